#pragma once

#include "ray_files/table_format.hpp"

#include <planetree/hit/hit.hpp>

#include <cstdint>
#include <span>
#include <string>

/// Hits as tables, in the order of the rays. As CSV a header and a line for each answer; numbers
/// are the shortest decimals that are read back as the same bits. As .npy an array of records with
/// the same names, in the machine's byte order. A miss has t = inf and the ids -1.
namespace planetree::tool {

/// Whether a ray hits anything.
struct Occlusion {
  bool isHit = false;
};

/// One of the hits of a ray.
template <class T>
struct NumberedHit {
  std::uint64_t ray = 0;  ///< counted from 0 over all rays
  Hit<T> hit;
};

/// What stands before the hits; it is as long for any count. CSV has no use for the count.
/// `Answer` is `Hit<T>`, `NumberedHit<T>` or `Occlusion`.
template <class Answer>
[[nodiscard]] std::string tableHeader(TableFormat format, std::uint64_t count);

/// Appends the hits to a table.
template <class Answer>
void appendRows(std::string& table, TableFormat format, std::span<const Answer> answers);

extern template std::string tableHeader<Hitf>(TableFormat, std::uint64_t);
extern template std::string tableHeader<Hitd>(TableFormat, std::uint64_t);
extern template std::string tableHeader<NumberedHit<float>>(TableFormat, std::uint64_t);
extern template std::string tableHeader<NumberedHit<double>>(TableFormat, std::uint64_t);
extern template std::string tableHeader<Occlusion>(TableFormat, std::uint64_t);
extern template void appendRows<Hitf>(std::string&, TableFormat, std::span<const Hitf>);
extern template void appendRows<Hitd>(std::string&, TableFormat, std::span<const Hitd>);
extern template void appendRows<NumberedHit<float>>(std::string&, TableFormat,
                                                    std::span<const NumberedHit<float>>);
extern template void appendRows<NumberedHit<double>>(std::string&, TableFormat,
                                                     std::span<const NumberedHit<double>>);
extern template void appendRows<Occlusion>(std::string&, TableFormat, std::span<const Occlusion>);

}  // namespace planetree::tool
