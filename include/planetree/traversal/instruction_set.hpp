#pragma once

#include <span>
#include <string_view>

/// The instruction sets that queries are compiled for. One build of the library holds all of those
/// of its kind of processor and uses the best one that the machine has; all give the same bits, so
/// that the choice is one of speed alone.
///
///     scalar                 plain code, on every machine
///     sse4, avx2, avx512     x86-64
///     neon                   AArch64
///
/// The environment variable PLANETREE_ISA forces one of them. A name that does not exist, or which
/// this machine cannot run, is passed over: the library never prints and never fails for it. A
/// program that wants to tell its user compares what is requested with what is active.
///
/// Any number of threads at once.
namespace planetree {

/// The set that queries use. Chosen once, at the first query or the first call: later changes of
/// the environment have no effect.
[[nodiscard]] std::string_view activeInstructionSet() noexcept;

/// Those that this machine can run and this build holds, the best one first; the last one is
/// scalar. The names are there as long as the program runs.
[[nodiscard]] std::span<const std::string_view> supportedInstructionSets() noexcept;

/// The value of PLANETREE_ISA, whether there is such a set or not; empty if it is not set. It lives
/// as long as the environment stays unchanged.
[[nodiscard]] std::string_view requestedInstructionSet() noexcept;

}  // namespace planetree
