// planetree-assimp: reads one model with assimp and tells what it found as message.hpp says. It is
// started by planetree, not by people.

#include "import/assimp/mesh_sender.hpp"
#include "import/assimp/message_writer.hpp"
#include "import/assimp/process_limits.hpp"
#include "import/assimp/regular_files.hpp"
#include "import/assimp/scene_sender.hpp"

#include <assimp/importerdesc.h>
#include <assimp/scene.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <string_view>

namespace {

using namespace planetree::importing;

/// What assimp warns of, told on.
class Remarks : public Assimp::LogStream {
 public:
  explicit Remarks(MessageWriter& writer) noexcept : writer_(writer) {}

  void write(const char* message) override {
    // "Warn,  T0: ..."
    std::string_view text = message;
    const std::size_t mark = text.find(": ");
    if (mark != std::string_view::npos && text.substr(0, mark).find(" T") != std::string_view::npos)
      text.remove_prefix(mark + 2);
    // What the Blender reader says, many times for each file, is only this.
    if (text.starts_with("<add reason>"))
      return;
    // We do read those above 2.
    if (text.find("unexpected illumination model") != std::string_view::npos)
      return;
    writer_.say(MessageKind::Remark, text);
  }

 private:
  MessageWriter& writer_;
};

/// What is asked for.
struct Request {
  const char* path = nullptr;
  bool isScene = false;  ///< or the geometry alone
};

/// planetree reads these by itself, and never through assimp: one file must not be two meshes. But
/// only assimp reads the materials of OBJ files.
void leaveOwnFormats(Assimp::Importer& importer, const Request& request) {
  for (const char* const extension : {"ply", "stl", "off"})
    importer.UnregisterLoader(importer.GetImporter(extension));
  if (!request.isScene)
    importer.UnregisterLoader(importer.GetImporter("obj"));
}

/// "glTF2 Importer" as "glTF2".
std::string formatName(const Assimp::Importer& importer) {
  const auto index = static_cast<std::size_t>(importer.GetPropertyInteger("importerIndex", -1));
  const aiImporterDesc* const description = importer.GetImporterInfo(index);
  if (!description || !description->mName)
    return "assimp";
  const std::string_view name = description->mName;
  for (const std::string_view ending : {" Importer", " importer", " Reader"}) {
    const std::size_t begin = name.find(ending);
    if (begin != std::string_view::npos)
      return std::string(name.substr(0, begin));
  }
  return std::string(name);
}

std::string contentOf(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// assimp knows most formats by content if the name says nothing, but not binary glTF.
bool isUnnamedGlb(const char* path) {
  char mark[4] = {};
  std::ifstream(path, std::ios::binary).read(mark, sizeof(mark));
  const bool isNamed = std::string_view(path).ends_with(".glb");
  return !isNamed && std::string_view(mark, sizeof(mark)) == "glTF";
}

const aiScene* readFile(Assimp::Importer& importer, const char* path) {
  if (!isUnnamedGlb(path))
    return importer.ReadFile(path, 0);
  const std::string bytes = contentOf(path);
  return importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
}

bool isUnknownFormat(std::string_view reason) noexcept {
  return reason.find("No suitable reader found") != std::string_view::npos;
}

void read(const Request& request, MessageWriter& writer) {
  Assimp::DefaultLogger::create(nullptr, Assimp::Logger::NORMAL, 0);
  Assimp::DefaultLogger::get()->attachStream(new Remarks(writer),
                                             Assimp::Logger::Err | Assimp::Logger::Warn);
  Assimp::Importer importer;
  // It becomes the importer's own.
  importer.SetIOHandler(new RegularFiles);
  leaveOwnFormats(importer, request);
  const aiScene* const scene = readFile(importer, request.path);
  if (!scene) {
    // assimp catches what its readers throw, and keeps it.
    if (importer.GetException())
      std::rethrow_exception(importer.GetException());
    const std::string reason = importer.GetErrorString();
    const FailureKind kind =
        isUnknownFormat(reason) ? FailureKind::UnknownFormat : FailureKind::Malformed;
    return writer.sayFailure(kind, reason);
  }
  const std::string format = formatName(importer);
  writer.say(MessageKind::Format, format);
  if (request.isScene)
    sendScene(*scene, format, std::filesystem::path(request.path).parent_path(), writer);
  else
    sendGeometry(*scene, writer);
  writer.say(MessageKind::End);
}

void readOrSayWhyNot(const Request& request, MessageWriter& writer) {
  try {
    read(request, writer);
  } catch (const TooManyVertices&) {
    writer.sayFailure(FailureKind::TooLarge, {});
  } catch (const std::bad_alloc&) {
    writer.sayFailure(FailureKind::OutOfMemory, {});
  } catch (const std::exception& error) {
    writer.sayFailure(FailureKind::Malformed, error.what());
  } catch (...) {
    writer.sayFailure(FailureKind::Malformed, "assimp gives no reason");
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool isScene = argc == 5 && std::string_view(argv[4]) == kSceneRequest;
  if (argc != 4 && !isScene) {
    std::fputs("planetree-assimp is a part of planetree, which starts it. See planetree --help.\n",
               stderr);
    return 2;
  }
  const int pipe = takeStandardOutput();
  limitProcess(std::strtoull(argv[2], nullptr, 10), std::strtol(argv[3], nullptr, 10));
  MessageWriter writer(pipe);
  readOrSayWhyNot({argv[1], isScene}, writer);
  // All has been told. Taking a scene of a bad file apart is one more chance to crash.
  std::_Exit(EXIT_SUCCESS);
}
