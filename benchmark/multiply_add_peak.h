#pragma once

namespace contact_shapelets {

/// Runs `rounds` rounds of independent multiply-adds on registers with the named instruction set (as
/// KernelInstructionSet() names it), and returns how many single-precision ones that were.
double MultiplyAdds(const char* instruction_set, int rounds);

}  // namespace contact_shapelets
