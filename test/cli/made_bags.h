#pragma once

#include <string>
#include <vector>

/// \file
/// Small bags with known contents, made from a seed.

namespace contact_shapelets::test {

/// What is done to the wrench of a made bag.
enum class Flaw {
  kNone,
  kNotFinite,   ///< every 50th sample is NaN
  kFrozen,      ///< the first message again and again, stamp and all
  kRepeated,    ///< every 10th message twice, stamp and all
  kFlat,        ///< a new stamp, but always the same force
  kZeroStamps,  ///< no stamp
  kLateStamps,  ///< stamps of a clock that is an hour behind
  kGap,         ///< half a second is missing within each episode
};

/// A bag of `episodes` pushes at 100 Hz with force pulses of three forms in turn, 3 s each.
struct MadeBag {
  int episodes = 6;
  Flaw flaw = Flaw::kNone;
  std::vector<std::string> wrench_topics{"/wrench"};
  bool triggers = true;  ///< episode_active around each push, 2.4 s
  bool outcomes = true;  ///< "sharp", "broad" and "double" after each push
  bool cut_off = false;  ///< it ends in the middle of the last push
};

/// Copies all messages of the `bags` into one, and returns `path`.
std::string Merge(const std::vector<std::string>& bags, const std::string& path);

/// Writes the bag and returns `path`.
std::string Make(const std::string& path, const MadeBag& content);

/// Copies the first `count` Episode messages of `source` to `path`, and returns `path`.
std::string CutEpisodes(const std::string& source, int count, const std::string& path);

/// Writes a bag that says it holds a ShapeletModel, but of another definition, and returns `path`.
std::string MakeModelOfAnotherVersion(const std::string& path);

}  // namespace contact_shapelets::test
