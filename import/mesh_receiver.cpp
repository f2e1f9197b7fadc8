#include "import/mesh_receiver.hpp"

#include <cmath>

namespace planetree::importing {
namespace {

/// A coordinate as it will be in the mesh; counts those that only T makes infinite.
template <std::floating_point T>
T rounded(double coordinate, detail::MeshBuilder<T>& builder) {
  const auto result = static_cast<T>(coordinate);
  if (std::isinf(result) && std::isfinite(coordinate))
    builder.countTooLarge(1);
  return result;
}

}  // namespace

template <std::floating_point T>
MeshReceiver<T>::MeshReceiver(const std::string& fileName)
    : input_{{}, fileName}, builder_(input_, MeshFormat::Other), welder_(builder_) {}

template <std::floating_point T>
void MeshReceiver<T>::receiveAll(MessageReader& messages) {
  while (true) {
    Message message = messages.next();
    if (message.kind == MessageKind::Failure)
      throw failureOf(message, input_.name);
    if (message.kind == MessageKind::End)
      break;
    receive(message);
  }
  polygon_.requireEnd();
}

template <std::floating_point T>
ImportReport MeshReceiver<T>::takeReport() {
  static_cast<MeshReadReport&>(report_) = builder_.takeReport();
  report_.remarks = remarks_.remarks();
  report_.remarkCount = remarks_.count();
  return std::move(report_);
}

template <std::floating_point T>
void MeshReceiver<T>::receive(Message& message) {
  switch (message.kind) {
    case MessageKind::Format:
      report_.formatName = presentable(message.text());
      break;
    case MessageKind::Remark:
      remarks_.add(message.text());
      break;
    case MessageKind::Mesh:
      beginMesh();
      break;
    case MessageKind::Vertices:
      receiveVertices(message);
      break;
    case MessageKind::Polygons:
      receivePolygons(message);
      break;
    case MessageKind::Unread:
      builder_.countUnread(message.take<std::uint64_t>());
      break;
    case MessageKind::Failure:
    case MessageKind::End:
      break;  // not for here: see receiveAll
    default:
      throw BrokenMessages("a scene is told of where a mesh was asked for");
  }
}

template <std::floating_point T>
void MeshReceiver<T>::beginMesh() {
  polygon_.requireEnd();
  vertices_.clear();
}

template <std::floating_point T>
void MeshReceiver<T>::receiveVertices(Message& message) {
  if (message.payload.size() % (3 * sizeof(double)) != 0)
    throw BrokenMessages("a vertex has no three coordinates");
  while (!message.payload.empty()) {
    Vec3<T> position;
    for (const Axis axis : kAxes)
      position[axis] = rounded(message.take<double>(), builder_);
    vertices_.push_back(welder_.vertexAt(position));
  }
}

template <std::floating_point T>
void MeshReceiver<T>::receivePolygons(Message& message) {
  polygon_.take(message, [&](std::span<const std::uint32_t> corners) { addPolygon(corners); });
}

template <std::floating_point T>
void MeshReceiver<T>::addPolygon(std::span<const std::uint32_t> corners) {
  builderCorners_.clear();
  for (const std::uint32_t corner : corners) {
    if (corner >= vertices_.size())
      return builder_.skipPolygon(detail::missingVertexReason(corner));
    builderCorners_.push_back(vertices_[corner]);
  }
  builder_.addPolygon(builderCorners_);
}

template class MeshReceiver<float>;
template class MeshReceiver<double>;

}  // namespace planetree::importing
