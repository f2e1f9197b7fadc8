#include "import/mesh_receiver.hpp"
#include "import/message_reader.hpp"

#include "support/input_messages.hpp"
#include "support/memory_file.hpp"
#include "support/mesh_promises.hpp"
#include "support/text_promises.hpp"

#include <chrono>
#include <vector>

// What a reading process may say of a mesh.

namespace planetree::fuzz {
namespace {

constexpr const char* kFile = "model.fbx";

/// Whether there is a mesh; else there were no clear messages, or such as tell of a failure.
template <class T>
bool receive(const std::vector<std::byte>& bytes) {
  using Clock = importing::MessageReader::Clock;
  const MemoryFile pipe(bytes);
  importing::MessageReader messages(pipe.number(), Clock::now() + std::chrono::minutes(10));
  try {
    importing::MeshReceiver<T> receiver(kFile);
    receiver.receiveAll(messages);
    const TriangleMesh<T> mesh = receiver.takeMesh();
    const importing::ImportReport report = receiver.takeReport();
    requireSoundMesh(mesh, bytes.size());
    requireSoundReport(mesh, report);
    requireSoundTexts(report);
    return true;
  } catch (const importing::BrokenMessages&) {
  } catch (const importing::MessagesEnd&) {
  } catch (const Error& error) {
    require(error.file() == kFile && !error.advice().empty(), "an error names the file");
  }
  return false;
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree::fuzz;
  const std::vector<std::byte> bytes = messagesOf(ByteStream(data, size));
  require(receive<float>(bytes) == receive<double>(bytes),
          "what is received does not depend on the precision");
  return 0;
}
