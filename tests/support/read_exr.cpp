#include "support/read_exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <cstring>
#include <stdexcept>

namespace planetree::test {

namespace {

class MemoryStream final : public Imf::IStream {
 public:
  explicit MemoryStream(const std::string& bytes) : Imf::IStream("bytes"), bytes_(bytes) {}

  bool read(char data[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (size > bytes_.size() - position_)
      throw std::runtime_error("the file ends early");
    std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const std::string& bytes_;
  std::size_t position_ = 0;
};

ExrFile contents(Imf::InputFile& input) {
  const Imf::Header& header = input.header();
  const Imath::Box2i window = header.dataWindow();
  ExrFile file{.width = static_cast<std::uint32_t>(window.max.x - window.min.x + 1),
               .height = static_cast<std::uint32_t>(window.max.y - window.min.y + 1),
               .firstX = window.min.x,
               .firstY = window.min.y,
               .wholeWidth = static_cast<std::uint32_t>(header.displayWindow().max.x + 1),
               .wholeHeight = static_cast<std::uint32_t>(header.displayWindow().max.y + 1),
               .channels = {},
               .texts = {}};
  Imf::FrameBuffer frame;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    ExrChannel& read = file.channels[channel.name()];
    read.isHalf = channel.channel().type == Imf::HALF;
    read.values.resize(std::size_t{file.width} * file.height);
    // OpenEXR turns halves into floats, which is exact.
    frame.insert(channel.name(), Imf::Slice::Make(Imf::FLOAT, read.values.data(), window));
  }
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
      file.texts[attribute.name()] = text->value();
  }
  return file;
}

}  // namespace

std::optional<ExrFile> readExr(const std::string& bytes) try {
  MemoryStream stream(bytes);
  Imf::InputFile input(stream);
  return contents(input);
} catch (const std::exception&) {
  return std::nullopt;
}

}  // namespace planetree::test
