#pragma once

#include <string>

/// \file
/// What is wrong with recorded or streamed data. (What is wrong with parameters or a model is a fault, which stops the
/// work; a finding does not.)

namespace contact_shapelets::core {

/// How grave a finding is.
enum class Severity {
  kInformation,  ///< worth knowing, nothing to do
  kWarning,      ///< some results may be wrong
  kError,        ///< results are wrong, or there are none
};

/// Something that is wrong with data.
struct Finding {
  Severity severity = Severity::kWarning;  ///< how grave it is
  std::string text;                        ///< what is wrong, with figures
  std::string remedy;                      ///< what to do about it
};

}  // namespace contact_shapelets::core
