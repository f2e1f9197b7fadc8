#pragma once

#include "ray_files/ray_reader.hpp"

#include <bit>

namespace planetree::tool {

/// Rays from a .npy file: an N x 6 or N x 8 array of float32 or float64 in either byte order, row
/// after row.
class NpyRayReader final : public RayReader {
 public:
  /// Reads the header. Throws `Error` with `MalformedFile` if it is not that of such an array, or
  /// promises more rays than a regular file has.
  explicit NpyRayReader(ByteSource source);

  [[nodiscard]] TableFormat format() const noexcept override { return TableFormat::Npy; }
  [[nodiscard]] bool isDouble() const noexcept override { return isDouble_; }
  [[nodiscard]] std::optional<std::uint64_t> rayCount() const noexcept override {
    return rayCount_;
  }
  [[nodiscard]] std::optional<double> progress() const noexcept override;

  /// Besides, throws `Error` at the end if there were fewer or more bytes than the header promised.
  [[nodiscard]] bool next(RayBlock& block, const KeepsGoing& keepsGoing) override;
  [[nodiscard]] std::vector<Rayf> decodeFloat(const RayBlock& block) const override;
  [[nodiscard]] std::vector<Rayd> decodeDouble(const RayBlock& block) const override;

 private:
  void readHeader();
  void takeType(const std::string& type);
  void takeShape(const std::vector<std::uint64_t>& shape);
  void checkSize() const;
  void checkEnd(const KeepsGoing& keepsGoing);
  [[noreturn]] void refuseTruncated(std::uint64_t presentCount) const;
  [[nodiscard]] std::size_t rowBytes() const noexcept;
  template <class T>
  std::vector<Ray<T>> decode(const RayBlock& block) const;

  ByteSource source_;
  bool isDouble_ = false;
  std::endian order_ = std::endian::little;
  std::size_t columnCount_ = 0;
  std::uint64_t rayCount_ = 0;
  std::uint64_t readCount_ = 0;  ///< rays in the blocks so far
  std::string pending_;          ///< the start of a ray whose end has not arrived yet
};

}  // namespace planetree::tool
