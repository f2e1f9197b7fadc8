#include "import/message_reader.hpp"
#include "import/scene_receiver.hpp"

#include "support/input_messages.hpp"
#include "support/memory_file.hpp"
#include "support/scene_promises.hpp"
#include "support/text_promises.hpp"

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

// What a reading process may say of a scene.

namespace planetree::fuzz {
namespace {

constexpr const char* kFile = "model.gltf";

void receive(const std::vector<std::byte>& bytes) {
  using Clock = importing::MessageReader::Clock;
  const MemoryFile pipe(bytes);
  importing::MessageReader messages(pipe.number(), Clock::now() + std::chrono::minutes(10));
  try {
    importing::SceneReceiver receiver(kFile);
    receiver.receiveAll(messages);
    scene::SceneDescription scene = receiver.takeScene();
    requireSoundTexts(receiver.takeReport());
    for (const scene::Material& material : scene.materials)
      requireSoundText(material.name);
    for (const scene::PlacedShape& shape : scene.shapes)
      requireSoundText(shape.name);
    for (const std::string& remark : scene.remarks)
      requireSoundText(remark);
    checkScene(std::move(scene), bytes.size());
  } catch (const importing::BrokenMessages&) {
  } catch (const importing::MessagesEnd&) {
  } catch (const Error& error) {
    require(error.file() == kFile && !error.advice().empty(), "an error names the file",
            [&error] { return std::string(error.what()); });
  }
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree::fuzz;
  receive(messagesOf(ByteStream(data, size)));
  return 0;
}
