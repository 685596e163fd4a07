#pragma once

/// \file
/// The inner loops of the transform-free kernel, built once per instruction set. Plain pointers only: inline code of
/// the standard library or of Eigen, built here with wide vectors, could end up in programs on machines without them.
///
/// Loops go over tiles: neighbouring positions of the shapelet's first sample, of which a few vectors stay in registers
/// while the overlap changes. Position p and an overlap of L samples belong to one window: p + L - M where the
/// shapelet's first L samples overlap (w > 0), p + M - L where its last L do (w < 0). The second case is the first one
/// mirrored, so both share their loops: `direction` is 1 or -1, and arrays by overlap begin at the end of the shapelet
/// that always overlaps.

namespace contact_shapelets::core::tile {

/// Shapelets whose values are interleaved, sample by sample, and that share a pass of overlaps.
constexpr int kGroup = 4;
/// Readable floats that arrays by position or window have before their first and behind their last used value, beside
/// the length of a shapelet.
constexpr int kPadding = 64;
/// M sigma of a window that does not count: no sum exceeds it.
constexpr float kNever = 1e30F;

/// Full overlaps of a group: sums[i stride + p] = sum_m shapelets[kGroup m + i] series[p + m] at 0 <= p < count,
/// rounded up to whole tiles, and the largest sum times scale.
struct FullArguments {
  const float* series;     ///< at position 0
  const float* shapelets;  ///< of the group
  const float* scale;      ///< 1 / (M sigma) by window; 0 where a window does not count
  float* sums;
  float* largest;  ///< sum in each tile, at least 0: largest[kGroup tile + i]. Where no window of a tile counts, `sums`
                   ///< are left out, largest[kGroup tile] is -1, and the others are unset
  bool with_largest;  ///< else largest[kGroup tile] alone is set: to 0 where a window of the tile counts
  int length;
  int count;
  int stride;
};
struct FullResult {
  float most[kGroup];    ///< at least 0
  int position[kGroup];  ///< of `most`; -1 where it is 0
};

/// Blocks that the M - 1 partial overlaps are divided into at the most, for bounds that all in a block share.
constexpr int kBlocks = 16;
/// A bit for each of them.
using BlockBits = unsigned short;
/// What bounds the values of a tile in each block of overlaps: the largest ones of all windows that these reach. Zeros
/// where there is no block.
struct Bounds {
  float head[kBlocks];  ///< part of a window's energy within the overlap, [0, 1]
  float
      tail[kBlocks];  ///< energy, about the window's mean, of what the shapelet's other samples fall on, over M sigma^2
  float scale[kBlocks];  ///< 1 / (M sigma)
};
/// The same of a shapelet.
struct Energies {
  float head[kBlocks];  ///< the largest part of its energy within the overlap, [0, 1]
  float tail[kBlocks];  ///< the largest part without
};

/// Partial overlaps of a group of shapelets.
struct PartialArguments {
  const float* values;       ///< by overlap from 1: what the overlap's last sample multiplies, interleaved as the group
  const float* within;       ///< by overlap from 0: the sum of the shapelet's values within, interleaved
  const float* energy;       ///< by overlap from 0: the part of the shapelet's energy within, interleaved
  const float* samples;      ///< of the series: the overlap's last sample at position 0 and overlap 1
  const float* mean;         ///< mu of the window of position 0 and overlap 0
  const float* spread;       ///< M sigma of that window; huge where a window does not count
  const float* scale;        ///< 1 / (M sigma) of that window; 0 where a window does not count
  const float* sums;         ///< full overlaps at position 0
  const float* largest;      ///< full overlap by tile, interleaved; -1 where a tile has none
  const Energies* energies;  ///< of the shapelets
  const Bounds* bounds;      ///< by tile; none where `energy` alone is to prune
  BlockBits* low;            ///< by tile, interleaved: blocks to be left out, which hold nothing better; null for none
  bool prune;                ///< else all overlaps are searched, and `bounds` are left out
  int length;                ///< M
  int windows;               ///< in the stretch
  int count;                 ///< shapelets in the group
  int block;                 ///< overlaps in a block: block b has those from b block + 1 to (b + 1) block
  int direction;
  int stride;             ///< between the shapelets in `sums`
  int full_tiles;         ///< tiles 0 ... full_tiles - 1 have their full overlaps in `sums`
  float best[kGroup];     ///< what a value must exceed, above 0; more than 1 for a shapelet that does not count
  unsigned renewed;       ///< bits of the shapelets whose searched blocks are added to `low` where all values are low
  float lowered[kGroup];  ///< what no low value exceeds, above 0 and at most `best`; `best` where not to be renewed
};
/// A value, and where it is.
struct TileResult {
  float value;
  int position;
  int overlap;
};

/// Windows in the form that the loops take; arrays by window begin at the first one of the stretch.
struct WindowArguments {
  const double* mean;     ///< mu
  const double* inverse;  ///< 1 / sigma; 0 where a window does not count
  const float* squares;   ///< by q, the sum of the squares of the first q samples
  double centre;          ///< what the series was centred by
  double hard_ratio;      ///< energy near a window over its variance that is too much for single precision
  int length;             ///< M
  int count;              ///< windows
  float* centred_mean;    ///< to be filled where a window counts and is not hard, as `spread` and `scale` are
  float* spread;          ///< M sigma; `kNever` elsewhere
  float* scale;           ///< 1 / (M sigma)
};

/// What makes the table of bounds: sums over the first q samples of a series, and the windows.
struct BoundArguments {
  const float* sums;     ///< of the values, by q
  const float* squares;  ///< of their squares, by q
  const float* mean;     ///< mu by window
  const float* scale;    ///< 1 / (M sigma) by window; 0 where a window does not count
  float rounding;        ///< what these sums may be off by, in the unit of the squares
  int length;            ///< M
  int block;             ///< overlaps in a block
  int count;             ///< windows
  int further_tiles;     ///< tiles before position 0 and behind the last window's
  int tiles;             ///< with these
  float* heads;          ///< scratch by window, zeros beyond the windows, as far as the bounds reach
  float* tails;          ///< the same
  float* energy_scale;   ///< scratch by window, without such zeros
  float* before_window;  ///< the same
  float* to_window_end;  ///< the same
  Bounds* prefix;        ///< by tile, from the first one: overlaps of the shapelet's first samples, w > 0
  Bounds* suffix;        ///< the same of its last samples
};

/// The loops for one instruction set.
struct Loops {
  const char* name;
  int positions;    ///< in a tile
  int vector_bits;  ///< of a vector
  void (*full_overlaps)(const FullArguments& arguments, FullResult* result);
  /// The first tile of tile ... end - 1 in which a shapelet of the group exceeds its `best`, and a bit in `better` for
  /// each that does; `end` where there is none.
  int (*find_better)(const PartialArguments& arguments, int tile, int end, unsigned* better);
  /// The largest value of one shapelet of the group in a tile, among those that the bounds leave.
  void (*most_in_tile)(const PartialArguments& arguments, int shapelet, int tile, TileResult* result);
  /// sum (t_m - mean) s_m over `count` samples, in double precision.
  double (*correlation)(const float* shapelet, const float* samples, double mean, int count);
  /// Returns how many windows are hard: these are left out, and so are those that do not count.
  int (*window_values)(const WindowArguments& arguments);
  void (*all_bounds)(const BoundArguments& arguments);
};

/// What every machine of this architecture runs.
Loops BaselineLoops();
#if defined(__x86_64__)
/// For machines with AVX2 and FMA.
Loops Avx2Loops();
/// For machines with AVX-512 F, VL, DQ and BW: its registers in half their width.
Loops Avx512HalfLoops();
/// The same in full.
Loops Avx512Loops();
#endif

}  // namespace contact_shapelets::core::tile
