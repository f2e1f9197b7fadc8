#include "import/mesh_receiver.hpp"

#include <algorithm>
#include <cmath>

namespace planetree::importing {
namespace {

/// Remarks that are kept, each once; the others are only counted.
constexpr std::size_t kKeptRemarks = 16;

/// A coordinate as it will be in the mesh; counts those that only T makes infinite.
template <std::floating_point T>
T rounded(double coordinate, detail::MeshBuilder<T>& builder) {
  const auto result = static_cast<T>(coordinate);
  if (std::isinf(result) && std::isfinite(coordinate))
    builder.countTooLarge(1);
  return result;
}

}  // namespace

std::string presentable(const std::string& text) {
  constexpr std::size_t kLongest = 300;
  constexpr unsigned char kDelete = 0x7F;
  std::string line;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool isShown = code > ' ' && code < kDelete;
    if (isShown)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.size() > kLongest)
    line = line.substr(0, kLongest) + " ...";
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
    line.pop_back();
  return line;
}

template <std::floating_point T>
MeshReceiver<T>::MeshReceiver(const std::string& fileName)
    : input_{{}, fileName}, builder_(input_, MeshFormat::Other), welder_(builder_) {}

template <std::floating_point T>
void MeshReceiver<T>::receiveAll(MessageReader& messages) {
  while (true) {
    Message message = messages.next();
    if (message.kind == MessageKind::Failure)
      throw failure(message);
    if (message.kind == MessageKind::End)
      break;
    receive(message);
  }
  if (missingCornerCount_ != 0)
    throw BrokenMessages("the last polygon lacks corners");
}

template <std::floating_point T>
ImportReport MeshReceiver<T>::takeReport() {
  static_cast<MeshReadReport&>(report_) = builder_.takeReport();
  return std::move(report_);
}

template <std::floating_point T>
void MeshReceiver<T>::receive(Message& message) {
  switch (message.kind) {
    case MessageKind::Format:
      report_.formatName = presentable(message.text());
      break;
    case MessageKind::Remark:
      receiveRemark(message);
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
  }
}

template <std::floating_point T>
void MeshReceiver<T>::receiveRemark(const Message& message) {
  ++report_.remarkCount;
  if (report_.remarks.size() == kKeptRemarks)
    return;
  std::string remark = presentable(message.text());
  const auto end = report_.remarks.end();
  if (std::find(report_.remarks.begin(), end, remark) == end)
    report_.remarks.push_back(std::move(remark));
}

template <std::floating_point T>
void MeshReceiver<T>::beginMesh() {
  if (missingCornerCount_ != 0)
    throw BrokenMessages("a polygon lacks corners");
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
  while (!message.payload.empty()) {
    const auto word = message.take<std::uint32_t>();
    if (missingCornerCount_ == 0) {
      missingCornerCount_ = word;
      corners_.clear();
    } else {
      corners_.push_back(word);
      --missingCornerCount_;
    }
    if (missingCornerCount_ == 0)
      endPolygon();
  }
}

template <std::floating_point T>
void MeshReceiver<T>::endPolygon() {
  builderCorners_.clear();
  for (const std::uint32_t corner : corners_) {
    if (corner >= vertices_.size())
      return builder_.skipPolygon(detail::missingVertexReason(corner));
    builderCorners_.push_back(vertices_[corner]);
  }
  builder_.addPolygon(builderCorners_);
}

template <std::floating_point T>
Error MeshReceiver<T>::failure(Message& message) const {
  const auto kind = static_cast<FailureKind>(message.take<std::uint32_t>());
  const Error::Place place{input_.name};
  switch (kind) {
    case FailureKind::UnknownFormat:
      return {ErrorCode::UnknownFormat, "the file is in none of the formats that can be read",
              "Convert it to PLY, STL, OBJ or glTF", place};
    case FailureKind::Malformed:
      return {ErrorCode::MalformedFile, "it cannot be read: " + presentable(message.text()),
              "If the file is whole, convert it to PLY, STL, OBJ or glTF with another program",
              place};
    case FailureKind::OutOfMemory:
      return {ErrorCode::MalformedFile, "reading it takes more memory than so small a file should",
              "If the file is whole, convert it to PLY or STL with another program", place};
    case FailureKind::TooLarge:
      return {ErrorCode::CapacityExceeded, "it has more vertices than 32 bits can count",
              "Divide the model into several files", place};
  }
  throw BrokenMessages("a failure of unknown kind");
}

template class MeshReceiver<float>;
template class MeshReceiver<double>;

}  // namespace planetree::importing
