#pragma once

#include <string>
#include <vector>

/// \file
/// Small bags with known contents, made from a seed.

namespace contact_shapelets::test {

/// The flaw of the wrench in a made bag.
enum class Flaw {
  kNone,
  kNotFinite,   ///< every 50th sample is NaN
  kFrozen,      ///< the driver repeats the first message with its stamp
  kRepeated,    ///< every 10th message repeats the one before, with its stamp
  kFlat,        ///< stamps are new, but the force is always the same
  kZeroStamps,  ///< messages have no stamp
  kLateStamps,  ///< stamps come from a clock that is an hour behind
  kGap,         ///< half a second is missing in each episode
  kPublishers,  ///< two drivers take turns on the topic
};

/// A bag of `episodes` pushes at 100 Hz, 3 s each. Their force pulses have three forms in turn.
struct MadeBag {
  int episodes = 6;
  Flaw flaw = Flaw::kNone;
  std::vector<std::string> wrench_topics{"/wrench"};
  bool triggers = true;  ///< whether `episode_active` marks 2.4 s around each push
  bool outcomes = true;  ///< whether "sharp", "broad" or "double" follows each push
  bool cut_off = false;  ///< whether it ends in the middle of the last push
};

/// Copies all messages of the `bags` into one, and returns `path`.
std::string Merge(const std::vector<std::string>& bags, const std::string& path);

/// Writes the bag and returns `path`.
std::string Make(const std::string& path, const MadeBag& content);

/// Copies the first `count` Episode messages of `source` to `path` and returns `path`.
std::string CutEpisodes(const std::string& source, int count, const std::string& path);

/// Writes a bag with a ShapeletModel of another definition and returns `path`.
std::string MakeModelOfAnotherVersion(const std::string& path);

}  // namespace contact_shapelets::test
