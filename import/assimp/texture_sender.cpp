#include "import/assimp/texture_sender.hpp"

#include "import/assimp/texture_path.hpp"

#include <planetree/error.hpp>

#include <array>
#include <cstddef>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <vector>

namespace planetree::importing {
namespace {

/// What the error says but for the file, which the remark names.
std::string reasonOf(const Error& error) {
  const std::string reason = error.what();
  const std::string start = error.file() + ": ";
  return reason.starts_with(start) ? reason.substr(start.size()) : reason;
}

}  // namespace

std::optional<std::uint32_t> TextureSender::send(const std::string& reference) {
  const auto known = sent_.find(reference);
  if (known != sent_.end())
    return known->second;
  std::optional<std::uint32_t> index;
  try {
    sendTexels(read(reference), reference);
    index = count_++;
  } catch (const std::bad_alloc&) {
    leaveOut(reference, "it takes too much memory");
  } catch (const Error& error) {
    leaveOut(reference, reasonOf(error));
  } catch (const std::exception& fault) {
    leaveOut(reference, fault.what());
  }
  sent_.emplace(reference, index);
  return index;
}

void TextureSender::leaveOut(const std::string& reference, const std::string& reason) {
  writer_.say(MessageKind::Remark, "the texture " + reference + " is left out: " + reason);
}

scene::Texture TextureSender::read(const std::string& reference) const {
  if (const aiTexture* const embedded = scene_.GetEmbeddedTexture(reference.c_str()))
    return readEmbedded(*embedded, reference);
  const auto path = findTexture(reference, folder_);
  if (!path)
    throw std::runtime_error("there is no such file beside the model");
  return scene::readTexture(*path);
}

scene::Texture TextureSender::readEmbedded(const aiTexture& texture,
                                           const std::string& reference) const {
  if (!texture.pcData)
    throw std::runtime_error("it is empty");
  // Without a height it is a file, whose size in bytes stands for the width.
  if (texture.mHeight == 0)
    return scene::readTexture(
        std::as_bytes(
            std::span(reinterpret_cast<const std::byte*>(texture.pcData), texture.mWidth)),
        reference);
  const std::uint64_t count = std::uint64_t{texture.mWidth} * texture.mHeight;
  if (count > kMaxTexels)
    throw std::runtime_error("it is too large");
  const auto part = [](unsigned char value) { return static_cast<float>(value) / 255.0f; };
  std::vector<Vec3f> texels;
  texels.reserve(count);
  for (const aiTexel& texel : std::span(texture.pcData, count))
    texels.push_back({part(texel.r), part(texel.g), part(texel.b)});
  return {texture.mWidth, texture.mHeight, std::move(texels)};
}

void TextureSender::sendTexels(const scene::Texture& texture, const std::string& reference) {
  const std::uint64_t count = std::uint64_t{texture.width()} * texture.height();
  if (count > kMaxTexels - texelCount_)
    throw std::runtime_error("all textures together are too large");
  texelCount_ += count;
  writer_.say(MessageKind::Texture,
              Payload().add(texture.width()).add(texture.height()).addText(reference));
  for (std::uint32_t y = 0; y < texture.height(); ++y) {
    for (std::uint32_t x = 0; x < texture.width(); ++x) {
      const Vec3f& texel = texture.texel(x, y);
      writer_.add(MessageKind::Texels, std::array{texel.x, texel.y, texel.z});
    }
  }
}

}  // namespace planetree::importing
