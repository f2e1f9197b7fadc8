#include "render/file/encode_exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string>

namespace planetree::render {

namespace {

/// A file in memory. OpenEXR goes back to its start in the end, to write where the lines are.
class MemoryStream final : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("picture") {}

  void write(const char bytes[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    if (end > bytes_.size())
      bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, bytes, static_cast<std::size_t>(count));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  [[nodiscard]] std::vector<std::byte>& bytes() noexcept { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

std::string attributeName(std::string key) {
  key.erase(std::remove(key.begin(), key.end(), ' '), key.end());
  key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
  return key;
}

Imath::Box2i windowOf(const PixelWindow& window) {
  const Imath::V2i first(static_cast<int>(window.x), static_cast<int>(window.y));
  const Imath::V2i size(static_cast<int>(window.size.width), static_cast<int>(window.size.height));
  return {first, first + size - Imath::V2i(1)};
}

/// The pixels that there are, in the coordinates of the whole picture.
Imath::Box2i dataWindow(const ChannelImage& image) {
  return windowOf({image.firstX, image.firstY, image.size});
}

Imf::Header makeHeader(const ChannelImage& image, const Metadata& metadata) {
  const bool isPart = image.wholeSize.pixelCount() != 0;
  Imf::Header header(windowOf({0, 0, isPart ? image.wholeSize : image.size}), dataWindow(image));
  header.compression() = Imf::ZIP_COMPRESSION;
  // The primaries of sRGB, which are also those that readers assume.
  Imf::addChromaticities(header, Imf::Chromaticities());
  for (const MetadataEntry& entry : metadata) {
    header.insert(attributeName(entry.key), Imf::StringAttribute(entry.text));
  }
  for (const Channel& channel : image.channels) {
    header.channels().insert(
        channel.name, Imf::Channel(channel.type == ChannelType::Half ? Imf::HALF : Imf::FLOAT));
  }
  return header;
}

std::vector<Imath::half> halves(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<std::byte> encodeExr(const ChannelImage& image, const Metadata& metadata) {
  std::vector<std::vector<Imath::half>> rounded;
  rounded.reserve(image.channels.size());
  const Imath::Box2i window = dataWindow(image);
  Imf::FrameBuffer frame;
  for (const Channel& channel : image.channels) {
    if (channel.type == ChannelType::Half) {
      const auto* const values = rounded.emplace_back(halves(channel.values)).data();
      frame.insert(channel.name, Imf::Slice::Make(Imf::HALF, values, window));
    } else {
      frame.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.values.data(), window));
    }
  }

  MemoryStream stream;
  {
    Imf::OutputFile file(stream, makeHeader(image, metadata));
    file.setFrameBuffer(frame);
    file.writePixels(static_cast<int>(image.size.height));
  }
  return std::move(stream.bytes());
}

}  // namespace planetree::render
