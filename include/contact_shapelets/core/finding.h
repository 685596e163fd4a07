#pragma once

#include <string>

/// \file
/// What is wrong with recorded or streamed data. A finding does not stop the work. A fault does: an invalid parameter
/// or model.

namespace contact_shapelets::core {

/// How grave a finding is.
enum class Severity {
  kInformation,  ///< worth knowing, nothing to do
  kWarning,      ///< some results may be wrong
  kError,        ///< results are wrong or missing
};

/// Something that is wrong with data.
struct Finding {
  Severity severity = Severity::kWarning;  ///< how grave it is
  std::string text;                        ///< what is wrong, with figures
  std::string remedy;                      ///< what to do about it
};

}  // namespace contact_shapelets::core
