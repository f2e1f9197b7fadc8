#include "import/mesh_receiver.hpp"
#include "import/message_reader.hpp"

#include "support/byte_stream.hpp"
#include "support/memory_file.hpp"
#include "support/mesh_promises.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

// What a reading process may say if it has gone mad. The first byte of an input says whether the
// greeting is part of the input or goes without saying.

namespace planetree::fuzz {
namespace {

constexpr const char* kFile = "model.fbx";

std::vector<std::byte> messagesOf(ByteStream input) {
  std::vector<std::byte> bytes;
  if (input.takeByte() != 0) {
    const auto greeting = std::as_bytes(std::span(importing::kGreeting));
    bytes.assign(greeting.begin(), greeting.end());
  }
  bytes.insert(bytes.end(), input.rest().begin(), input.rest().end());
  return bytes;
}

void requireSoundTexts(const importing::ImportReport& report) {
  require(report.remarks.size() <= report.remarkCount, "remarks that are kept are counted");
  std::vector<std::string> texts = report.remarks;
  texts.push_back(report.formatName);
  for (const std::string& text : texts) {
    require(std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < '\x7F'; }),
            "texts from outside have no control characters");
    require(text.size() < 400, "texts from outside are short");
  }
}

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
