#pragma once

#include <planetree/traversal/instruction_set.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

/// What the programs that test for long take from their command line.
namespace planetree::test {

struct ProgramOptions {
  std::uint64_t rays = 1'000'000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::uint64_t seed = 1;
  std::string instructionSet;  ///< empty: the best one
};

namespace detail {

template <class N>
bool readNumber(std::string_view text, N& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() && number > 0;
}

}  // namespace detail

/// Reads `--rays N`, `--threads N`, `--seed N` and `--isa NAME`, and sees to it that queries use
/// this instruction set; call it before the first query. Nothing, and a line about what is wrong,
/// if the program should not go on. A set that this machine does not have is wrong, too, unless
/// `--isa-if-there` asks for it: then there is nothing to do, and `isSkipped` says so.
inline std::optional<ProgramOptions> readProgramOptions(int count, const char* const* words,
                                                        bool& isSkipped) {
  ProgramOptions options;
  isSkipped = false;
  bool mayBeMissing = false;
  for (int i = 1; i < count; i += 2) {
    const std::string_view name = words[i];
    const std::string_view value = i + 1 < count ? words[i + 1] : "";
    bool isGood = !value.empty();
    if (name == "--rays") {
      isGood = detail::readNumber(value, options.rays);
    } else if (name == "--threads") {
      isGood = detail::readNumber(value, options.threads);
    } else if (name == "--seed") {
      isGood = detail::readNumber(value, options.seed);
    } else if (name == "--isa" || name == "--isa-if-there") {
      options.instructionSet = value;
      mayBeMissing = name != "--isa";
    } else {
      isGood = false;
    }
    if (!isGood) {
      std::cerr << "no such option, or no such number: " << name << ' ' << value
                << "\nuse [--rays N] [--threads N] [--seed N] [--isa NAME]\n";
      return std::nullopt;
    }
  }
  if (!options.instructionSet.empty()) {
    setenv("PLANETREE_ISA", options.instructionSet.c_str(), 1);
    if (activeInstructionSet() != options.instructionSet) {
      isSkipped = mayBeMissing;
      std::cerr << "this machine does not have the instruction set " << options.instructionSet
                << ". Those it has:";
      for (const std::string_view name : supportedInstructionSets())
        std::cerr << ' ' << name;
      std::cerr << '\n';
      return std::nullopt;
    }
  }
  options.instructionSet = activeInstructionSet();
  return options;
}

}  // namespace planetree::test
