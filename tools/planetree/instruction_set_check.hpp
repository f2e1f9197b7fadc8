#pragma once

namespace planetree::tool {

/// Throws `UsageError` if the environment variable PLANETREE_ISA asks for an instruction set that
/// this machine cannot run. The library would pass over it without a word.
void checkRequestedInstructionSet();

}  // namespace planetree::tool
