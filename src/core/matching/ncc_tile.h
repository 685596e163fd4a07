#pragma once

/// \file
/// The inner loops of the transform-free kernel, built once for each instruction set. They use plain pointers only: the
/// linker could pick an inline function of the standard library or of Eigen that was built here with wide vectors, and
/// a machine without these could not run it.
///
/// The loops go over tiles. A tile is a few vectors of neighbouring positions of the shapelet's first sample, which
/// stay in registers while the overlap changes. Position p and an overlap of L samples belong to one window: p + L - M
/// if the shapelet's first L samples overlap (w > 0), p + M - L if its last L samples do (w < 0). The second case
/// mirrors the first, so both share their loops: `direction` is 1 or -1, and arrays by overlap begin at the end of the
/// shapelet that always overlaps. "Interleaved" arrays hold the values of the kGroup shapelets of a group side by side.

namespace contact_shapelets::core::tile {

/// Shapelets in a group. They are interleaved sample by sample and share a pass of overlaps.
constexpr int kGroup = 4;
/// Arrays by position or window have M + kPadding readable floats before their first and behind their last used value.
constexpr int kPadding = 64;
/// M sigma of a window that does not count, because it is flat or needs double precision: no sum exceeds it.
constexpr float kNever = 1e30F;

/// Full overlaps of a group: sums[i stride + p] = sum_m shapelets[kGroup m + i] series[p + m] at 0 <= p < count, which
/// is a whole number of tiles, and the largest sum times scale.
struct FullArguments {
  const float* series;     ///< at position 0
  const float* shapelets;  ///< of the group
  const float* scale;      ///< 1 / (M sigma) by window; 0 if a window does not count
  float* sums;
  float* largest;     ///< largest sum in each tile, at least 0, at kGroup tile + i. If no window of a tile counts, the
                      ///< loops set largest[kGroup tile] to -1 and leave out the others and `sums`
  bool with_largest;  ///< if false, the loops set largest[kGroup tile] alone: to 0 if a window of the tile counts
  int length;
  int count;
  int stride;
};
/// The largest value of each shapelet over all windows.
struct FullResult {
  float most[kGroup];    ///< sum times scale, at least 0
  int position[kGroup];  ///< where it is; -1 if it is 0
};

/// Greatest number of blocks that the M - 1 partial overlaps are divided into. All overlaps of a block share a bound.
constexpr int kBlocks = 16;
/// A bit for each block.
using BlockBits = unsigned short;
/// Bounds on the values of a tile in each block of overlaps: the largest of all windows that the block reaches. Zeros
/// if there is no such block.
struct Bounds {
  /// Part of a window's energy within the overlap, [0, 1].
  float head[kBlocks];
  /// Energy, about the window's mean, of the samples under the rest of the shapelet, divided by M sigma^2.
  float tail[kBlocks];
  /// 1 / (M sigma).
  float scale[kBlocks];
};
/// The same for a shapelet.
struct Energies {
  float head[kBlocks];  ///< largest part of its energy within the overlap, [0, 1]
  float tail[kBlocks];  ///< largest part of its energy outside of the overlap, [0, 1]
};

/// Partial overlaps of a group of shapelets.
struct PartialArguments {
  const float* values;       ///< by overlap from 1: the shapelet's value at the overlap's last sample, interleaved
  const float* within;       ///< by overlap from 0: sum of the shapelet's values within it, interleaved
  const float* energy;       ///< by overlap from 0: part of the shapelet's energy within it, interleaved
  const float* samples;      ///< of the series: the overlap's last sample at position 0 and overlap 1
  const float* mean;         ///< mu of the window of position 0 and overlap 0
  const float* spread;       ///< M sigma of that window; kNever if a window does not count
  const float* scale;        ///< 1 / (M sigma) of that window; 0 if a window does not count
  const float* sums;         ///< full overlaps at position 0
  const float* largest;      ///< largest full overlap by tile, interleaved; -1 if a tile has none
  const Energies* energies;  ///< by shapelet of the group
  const Bounds* bounds;      ///< by tile; null if `energy` alone prunes
  BlockBits* low;            ///< by tile, interleaved: blocks that hold nothing better and are skipped; null for none
  bool prune;                ///< if false, all overlaps are searched; then `bounds` are null
  int length;                ///< M
  int windows;               ///< windows in the stretch
  int count;                 ///< shapelets in the group
  int block;                 ///< overlaps in a block: block b has those from b block + 1 to (b + 1) block
  int direction;             ///< 1 for w > 0, -1 for w < 0
  int stride;                ///< floats from one shapelet to the next in `sums`
  int full_tiles;            ///< tiles 0 ... full_tiles - 1 have their full overlaps in `sums`
  float best[kGroup];        ///< threshold that a better value exceeds, above 0; above 1 if a shapelet does not count
  unsigned renewed;          ///< bits of the shapelets that are noted anew: the loops add their low blocks to `low`
  float lowered[kGroup];     ///< threshold of low values, above 0 and at most `best`; `best` without a bit in `renewed`
};
/// A value and where it is.
struct TileResult {
  float value;
  int position;
  int overlap;
};

/// Prepares windows for the loops. Arrays by window begin at the first window of the stretch.
struct WindowArguments {
  const double* mean;     ///< mu
  const double* inverse;  ///< 1 / sigma; 0 if a window is flat
  const float* squares;   ///< by q: sum of the squares of the first q samples
  double centre;          ///< mean that was subtracted from the series
  double hard_ratio;      ///< a window with more energy near it than this times sigma^2 needs double precision
  int length;             ///< M
  int count;              ///< number of windows
  float* centred_mean;    ///< result: mu - centre; 0 if a window does not count
  float* spread;          ///< result: M sigma; kNever if a window does not count
  float* scale;           ///< result: 1 / (M sigma); 0 if a window does not count
};

/// Makes the table of bounds from sums over the first q samples of a series and from the windows.
struct BoundArguments {
  const float* sums;     ///< by q: sum of the first q values
  const float* squares;  ///< by q: sum of their squares
  const float* mean;     ///< mu by window
  const float* scale;    ///< 1 / (M sigma) by window; 0 if a window does not count
  float rounding;        ///< bound on the rounding error of these sums, in the unit of the squares
  int length;            ///< M
  int block;             ///< overlaps in a block
  int count;             ///< number of windows
  int further_tiles;     ///< tiles on either side of those that hold the windows' positions
  int tiles;             ///< all tiles
  float* heads;          ///< scratch by window, with zeros on either side as far as the bounds reach
  float* tails;          ///< as `heads`
  float* energy_scale;   ///< scratch by window, without zeros on either side
  float* before_window;  ///< as `energy_scale`
  float* to_window_end;  ///< as `energy_scale`
  Bounds* prefix;        ///< result by tile, from the first: overlaps of the shapelet's first samples, w > 0
  Bounds* suffix;        ///< result by tile, from the first: overlaps of its last samples, w < 0
};

/// The loops for one instruction set.
struct Loops {
  const char* name;
  int positions;    ///< positions in a tile
  int vector_bits;  ///< bits in a vector
  void (*full_overlaps)(const FullArguments& arguments, FullResult* result);
  /// Returns the first tile of tile ... end - 1 in which a shapelet of the group exceeds its `best`, and sets a bit of
  /// `better` for each that does. Returns `end` if there is none.
  int (*find_better)(const PartialArguments& arguments, int tile, int end, unsigned* better);
  /// Finds the largest value of one shapelet of the group in a tile, among the overlaps that the bounds leave.
  void (*most_in_tile)(const PartialArguments& arguments, int shapelet, int tile, TileResult* result);
  /// Returns sum (t_m - mean) s_m over `count` samples, in double precision.
  double (*correlation)(const float* shapelet, const float* samples, double mean, int count);
  /// Returns how many windows need double precision. These and flat windows do not count.
  int (*window_values)(const WindowArguments& arguments);
  void (*all_bounds)(const BoundArguments& arguments);
};

/// Loops for every machine of this architecture.
Loops BaselineLoops();
#if defined(__x86_64__)
/// Loops for machines with AVX2 and FMA.
Loops Avx2Loops();
/// Loops for machines with AVX-512 F, VL, DQ and BW, with vectors of 256 bits.
Loops Avx512HalfLoops();
/// Loops for the same machines with vectors of 512 bits.
Loops Avx512Loops();
#endif

}  // namespace contact_shapelets::core::tile
