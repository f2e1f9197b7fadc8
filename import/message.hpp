#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// What `planetree-assimp` tells the process that started it, through its standard output: the
/// greeting, then messages. Both sides are of one build and on one machine, so numbers are as in
/// memory. The reading side trusts none of them.
namespace planetree::importing {

inline constexpr std::string_view kGreeting = "planetree reads\n";

enum class MessageKind : std::uint32_t {
  Format,    ///< text: what kind of file it is
  Remark,    ///< text: what assimp warns of
  Mesh,      ///< nothing: the polygons to come refer to the vertices to come
  Vertices,  ///< three doubles for each vertex
  Polygons,  ///< words: the corner count of a polygon, its vertex indices within the mesh, and the
             ///< same for the next one; a polygon may go on in the next message
  Unread,    ///< a 64-bit count of points and lines
  Failure,   ///< a `FailureKind` and text: why there is no mesh; the last message
  End,       ///< nothing: all has been told; the last message
};

enum class FailureKind : std::uint32_t {
  UnknownFormat,  ///< assimp has no reader for this file
  Malformed,      ///< the reader does not get along with the file; the text is its reason
  OutOfMemory,
  TooLarge,  ///< more vertices than 32 bits can count
};

struct MessageHeader {
  MessageKind kind = MessageKind::End;
  std::uint32_t size = 0;  ///< bytes that follow
};

/// The most bytes of one message. Longer lists are told in several.
inline constexpr std::size_t kMaxMessageSize = std::size_t{1} << 16;

}  // namespace planetree::importing
