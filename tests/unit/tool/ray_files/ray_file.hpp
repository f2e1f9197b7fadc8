#pragma once

#include "ray_files/ray_reader.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace planetree::test {

/// A file that goes with the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes) {
    std::string pattern = (std::filesystem::temp_directory_path() / "planetree-XXXXXX").string();
    const int number = ::mkstemp(pattern.data());
    if (number < 0)
      throw std::runtime_error("no temporary file");
    ::close(number);
    path_ = pattern;
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// All rays of a file with these bytes, in blocks as the tool reads them.
template <class T>
std::vector<Ray<T>> readRays(const std::string& bytes) {
  const TemporaryFile file(bytes);
  const auto reader = tool::openRays(file.path());
  std::vector<Ray<T>> rays;
  tool::RayBlock block;
  while (reader->next(block, [] { return true; })) {
    std::vector<Ray<T>> more;
    if constexpr (std::is_same_v<T, float>) {
      more = reader->decodeFloat(block);
    } else {
      more = reader->decodeDouble(block);
    }
    rays.insert(rays.end(), more.begin(), more.end());
  }
  return rays;
}

/// The error that reading throws; a failure if it throws none.
inline std::optional<Error> errorOfRays(const std::string& bytes) {
  try {
    static_cast<void>(readRays<float>(bytes));
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error for " << bytes.substr(0, 80);
  return std::nullopt;
}

/// Expects a malformed file, words of the message, and advice.
inline void expectRefused(const std::string& bytes, const std::string& words,
                          std::int64_t line = Error::kNone) {
  const std::optional<Error> error = errorOfRays(bytes);
  if (!error)
    return;
  const std::string message = error->what();
  EXPECT_EQ(error->code(), ErrorCode::MalformedFile) << message;
  EXPECT_EQ(error->line(), line) << message;
  EXPECT_FALSE(error->advice().empty()) << message;
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

/// The same bits, so that two NaNs are equal and two signed zeros are not.
template <class T>
bool haveSameBits(T a, T b) {
  using Bytes = std::array<std::byte, sizeof(T)>;
  return std::bit_cast<Bytes>(a) == std::bit_cast<Bytes>(b);
}

/// A .npy file of version 1.0 with this dictionary.
inline std::string npyFile(const std::string& dictionary, const std::string& data) {
  std::string bytes = "\x93NUMPY";
  bytes += std::string("\x01\x00", 2);
  bytes += static_cast<char>(dictionary.size() & 0xFF);
  bytes += static_cast<char>(dictionary.size() >> 8);
  return bytes + dictionary + data;
}

inline std::string npyDictionary(const std::string& type, const std::string& shape,
                                 const std::string& order = "False") {
  return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
}

/// The bytes of numbers, one after the other.
template <class Number>
std::string bytesOf(const std::vector<Number>& numbers, std::endian order = std::endian::little) {
  std::string bytes;
  for (const Number number : numbers) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (order != std::endian::native)
      std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

}  // namespace planetree::test
