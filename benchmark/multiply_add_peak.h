#pragma once

namespace contact_shapelets {

/// Runs `rounds` rounds of independent multiply-adds on registers with `instruction_set`, a name of
/// KernelInstructionSet(). Returns the number of single-precision multiply-adds; 0 if the compiler cannot build them.
double MultiplyAdds(const char* instruction_set, int rounds);

}  // namespace contact_shapelets
