#pragma once

#include "mesh/mesh_builder.hpp"
#include "mesh/mesh_input.hpp"

#include <concepts>

/// One reader for each format. All read `input.bytes` into the builder and throw `Error` if the
/// bytes break the rules of the format.
namespace planetree::detail {

template <std::floating_point T>
void readPly(const MeshInput& input, MeshBuilder<T>& builder);

template <std::floating_point T>
void readStlText(const MeshInput& input, MeshBuilder<T>& builder);

template <std::floating_point T>
void readStlBinary(const MeshInput& input, MeshBuilder<T>& builder);

template <std::floating_point T>
void readObj(const MeshInput& input, MeshBuilder<T>& builder);

template <std::floating_point T>
void readOff(const MeshInput& input, MeshBuilder<T>& builder);

/// True if the size of a binary STL file is the one that its triangle count demands. Only this
/// tells it apart: its first bytes are free and may even spell "solid", like those of a text.
[[nodiscard]] bool isStlBinary(std::span<const std::byte> bytes) noexcept;

/// True if the first record of a text is one of OBJ's, or if there are only comments.
[[nodiscard]] bool isObj(std::span<const std::byte> bytes) noexcept;

/// True if the first word that is no comment is one of OFF's headers.
[[nodiscard]] bool isOff(std::span<const std::byte> bytes) noexcept;

extern template void readPly<float>(const MeshInput&, MeshBuilder<float>&);
extern template void readPly<double>(const MeshInput&, MeshBuilder<double>&);
extern template void readStlText<float>(const MeshInput&, MeshBuilder<float>&);
extern template void readStlText<double>(const MeshInput&, MeshBuilder<double>&);
extern template void readStlBinary<float>(const MeshInput&, MeshBuilder<float>&);
extern template void readStlBinary<double>(const MeshInput&, MeshBuilder<double>&);
extern template void readObj<float>(const MeshInput&, MeshBuilder<float>&);
extern template void readObj<double>(const MeshInput&, MeshBuilder<double>&);
extern template void readOff<float>(const MeshInput&, MeshBuilder<float>&);
extern template void readOff<double>(const MeshInput&, MeshBuilder<double>&);

}  // namespace planetree::detail
