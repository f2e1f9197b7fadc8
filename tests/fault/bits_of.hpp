#pragma once

#include "node/wide_node.hpp"

#include <planetree/planetree.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

/// Results as bytes, to be compared.
namespace planetree::test {

template <class Value>
void appendBits(std::string& bits, std::span<const Value> values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  bits.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  bits += '|';
}

inline std::string bitsOf(const std::string& text) {
  return text;
}

template <class Value>
std::string bitsOf(const std::vector<Value>& values) {
  std::string bits;
  appendBits(bits, std::span<const Value>(values));
  return bits;
}

template <class T>
std::string bitsOf(const TriangleMesh<T>& mesh) {
  return bitsOf(mesh.positions) + bitsOf(mesh.faces) + bitsOf(mesh.sourceFaces);
}

template <class O>
std::string bitsOf(const KdTree<O>& tree) {
  std::string bits;
  appendBits(bits, tree.nodes());
  appendBits(bits, tree.view().references);
  if (tree.view().wide != nullptr) {
    appendBits(bits, tree.view().wide->nodes);
    appendBits(bits, tree.view().wide->blocks);
  }
  return bits;
}

}  // namespace planetree::test
