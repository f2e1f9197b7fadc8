#pragma once

#include "ray_files/ray_reader.hpp"

namespace planetree::tool {

/// Rays from comma-separated text: 6 numbers on each line, or 8 on each. Blank lines are skipped,
/// and so are lines that begin with #, as NumPy's `savetxt` writes its header. A first line without
/// any number is a header; the order of the columns is fixed, whatever it calls them.
class CsvRayReader final : public RayReader {
 public:
  explicit CsvRayReader(ByteSource source);

  [[nodiscard]] TableFormat format() const noexcept override { return TableFormat::Csv; }
  [[nodiscard]] bool isDouble() const noexcept override { return false; }
  [[nodiscard]] std::optional<std::uint64_t> rayCount() const noexcept override {
    return std::nullopt;
  }
  [[nodiscard]] std::optional<double> progress() const noexcept override;

  [[nodiscard]] bool next(RayBlock& block, const KeepsGoing& keepsGoing) override;
  [[nodiscard]] std::vector<Rayf> decodeFloat(const RayBlock& block) const override;
  [[nodiscard]] std::vector<Rayd> decodeDouble(const RayBlock& block) const override;

 private:
  bool nextLines(RayBlock& block, const KeepsGoing& keepsGoing);
  void findFirstRay(RayBlock& block);
  template <class T>
  std::vector<Ray<T>> decode(const RayBlock& block) const;

  ByteSource source_;
  std::string pending_;  ///< the start of a line whose end has not arrived yet
  std::uint64_t nextLine_ = 1;
  bool isPastHeader_ = false;
  std::size_t columnCount_ = 0;  ///< of the first ray; 0 before it
};

}  // namespace planetree::tool
