#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The header of NumPy's .npy files: magic, version, length, and a Python dictionary as text.
/// NumPy Enhancement Proposal 1, "A simple file format for NumPy arrays".
namespace planetree::tool {

inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

struct NpyHeader {
  std::string type;  ///< "<f4"; empty for an array of records
  bool isFortranOrder = false;
  std::vector<std::uint64_t> shape;
};

/// Parses the dictionary. Throws `Error` with `MalformedFile`, naming the file `name`.
[[nodiscard]] NpyHeader parseNpyHeader(std::string_view dictionary, const std::string& name);

/// Everything before the first of `count` records; `type` is a Python literal. The length does not
/// depend on `count`, so that the header can be replaced by one with another count.
[[nodiscard]] std::string makeNpyHeader(std::string_view type, std::uint64_t count);

/// An error of a .npy file. `problem` and `advice` as in `Error`.
[[noreturn]] void refuseNpy(const std::string& name, const std::string& problem,
                            const std::string& advice);

}  // namespace planetree::tool
