#include "unit/scene/ray_text.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

using scene::Material;
using scene::SceneDescription;

const Material& materialOf(const SceneDescription& scene, std::size_t shape) {
  return scene.materials.at(scene.shapes.at(shape).material);
}

TEST(RayMaterial, IsBlackByDefault) {
  const SceneDescription scene = readStatements("sphere {}");
  EXPECT_EQ(materialOf(scene, 0), Material{});
  EXPECT_EQ(materialOf(scene, 0).index.value, 1.0);
}

TEST(RayMaterial, HasAllItsValues) {
  const SceneDescription scene = readStatements(
      "sphere { material = { emissive = (1, 0, 0); ambient = (0, 1, 0); diffuse = (0, 0, 1);"
      "specular = (1, 1, 0); reflective = (1, 0, 1); transmissive = (0, 1, 1); index = 1.5;"
      "shininess = 20; name = \"all of it\"; }; }");
  const Material& material = materialOf(scene, 0);
  EXPECT_EQ(material.emissive.value, (Vec3d{1, 0, 0}));
  EXPECT_EQ(material.ambient.value, (Vec3d{0, 1, 0}));
  EXPECT_EQ(material.diffuse.value, (Vec3d{0, 0, 1}));
  EXPECT_EQ(material.specular.value, (Vec3d{1, 1, 0}));
  EXPECT_EQ(material.reflective.value, (Vec3d{1, 0, 1}));
  EXPECT_EQ(material.transmissive.value, (Vec3d{0, 1, 1}));
  EXPECT_EQ(material.index.value, 1.5);
  EXPECT_EQ(material.shininess.value, 20.0);
  EXPECT_EQ(material.name, "all of it");
  EXPECT_FALSE(material.diffuse.texture.has_value());
}

TEST(RayMaterial, AtTheTopIsForWhatFollows) {
  const SceneDescription scene = readStatements(
      "sphere {} material = { diffuse = (1, 0, 0) } sphere {}"
      "material = { ambient = (0, 1, 0) } sphere {}");
  EXPECT_EQ(materialOf(scene, 0).diffuse.value, (Vec3d{0, 0, 0}));
  EXPECT_EQ(materialOf(scene, 1).diffuse.value, (Vec3d{1, 0, 0}));
  EXPECT_EQ(materialOf(scene, 1).ambient.value, (Vec3d{0, 0, 0}));
  EXPECT_EQ(materialOf(scene, 2).diffuse.value, (Vec3d{1, 0, 0}));
  EXPECT_EQ(materialOf(scene, 2).ambient.value, (Vec3d{0, 1, 0}));
}

TEST(RayMaterial, OfAGroupEndsWithIt) {
  const SceneDescription scene = readStatements(
      "material = { diffuse = (1, 0, 0) }"
      "{ sphere {} material = { index = 2 } sphere {} scale(2, { material = { index = 3 } box {} })"
      "  cone {} } sphere {}");
  EXPECT_EQ(materialOf(scene, 0).index.value, 1.0);
  EXPECT_EQ(materialOf(scene, 1).index.value, 2.0);
  EXPECT_EQ(materialOf(scene, 2).index.value, 3.0);
  EXPECT_EQ(materialOf(scene, 3).index.value, 2.0);
  EXPECT_EQ(materialOf(scene, 4).index.value, 1.0);
  for (std::size_t shape = 0; shape < 5; ++shape)
    EXPECT_EQ(materialOf(scene, shape).diffuse.value, (Vec3d{1, 0, 0}));
}

TEST(RayMaterial, OfAShapeIsForTheShapeAlone) {
  const SceneDescription scene = readStatements(
      "material = { diffuse = (1, 0, 0) index = 2 }"
      "sphere { material = { index = 3 } } sphere {}");
  EXPECT_EQ(materialOf(scene, 0).index.value, 3.0);
  EXPECT_EQ(materialOf(scene, 0).diffuse.value, (Vec3d{1, 0, 0}));
  EXPECT_EQ(materialOf(scene, 1).index.value, 2.0);
}

TEST(RayMaterial, IsUsedByName) {
  const SceneDescription scene = readStatements(
      "material = { name = glass; index = 1.5 } material = { name \"old gold\" index = 2 }"
      "{ sphere { material = { name red diffuse = (1, 0, 0) } } }"
      "sphere { material = glass; } sphere { material = \"old gold\"; } sphere { material = red }"
      "sphere { material = \"glass\" } material = glass sphere {}");
  EXPECT_EQ(materialOf(scene, 1).index.value, 1.5);
  EXPECT_EQ(materialOf(scene, 2).index.value, 2.0);
  EXPECT_EQ(materialOf(scene, 2).name, "old gold");
  EXPECT_EQ(materialOf(scene, 3).diffuse.value, (Vec3d{1, 0, 0}));
  EXPECT_EQ(scene.shapes[4].material, scene.shapes[1].material);
  EXPECT_EQ(scene.shapes[5].material, scene.shapes[1].material);
}

TEST(RayMaterial, ThatInheritsIsNotTheNamedOne) {
  const SceneDescription scene = readStatements(
      "material = { name = glass; index = 1.5 } sphere { material = { ambient = (1,1,1) } }");
  EXPECT_EQ(materialOf(scene, 0).name, "");
  EXPECT_EQ(materialOf(scene, 0).index.value, 1.5);
}

TEST(RayMaterial, ThatSaysNothingIsTheSurroundingOne) {
  const SceneDescription scene =
      readStatements("material = { name = glass; index = 1.5 } sphere { material = {} }");
  EXPECT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(materialOf(scene, 0).name, "glass");
}

TEST(RayMaterial, NamesAreDefinedOnceAndBeforeTheyAreUsed) {
  EXPECT_EQ(errorOf("material = { name = red; }\nsphere { material = { name = red; } }"),
            "test.ray:3:30: the material \"red\" is defined a second time, after line 2, column "
            "21. Give one of them another name");
  EXPECT_EQ(errorOf("sphere { material = red; } material = { name = red; }"),
            "test.ray:2:21: there is no material \"red\" so far. Define it before it is used");
  EXPECT_EQ(errorOf("material = { name = glass } sphere { material = \"glas\"; }"),
            "test.ray:2:49: there is no material \"glas\" so far. Did you mean \"glass\"?");
}

TEST(RayMaterial, MayBeAnImage) {
  const SceneDescription scene = readStatements(
      "sphere { material = { diffuse = map(\"textures/chequer.png\");"
      "ambient = map(\"textures/../textures//chequer.png\"); specular = "
      "map(\"textures/polish.png\");"
      "shininess = map(\"textures/polish.png\"); index = map(\"textures/polish.png\"); } }");
  ASSERT_EQ(scene.textures.size(), 2u);  // each file once
  const Material& material = materialOf(scene, 0);
  EXPECT_EQ(material.diffuse.texture, 0u);
  EXPECT_EQ(material.diffuse.value, (Vec3d{1, 1, 1}));
  EXPECT_EQ(material.ambient.texture, 0u);
  EXPECT_EQ(material.specular.texture, 1u);
  EXPECT_EQ(material.shininess.texture, 1u);
  EXPECT_EQ(material.shininess.value, 128.0);
  EXPECT_EQ(material.index.texture, 1u);
  EXPECT_EQ(material.index.value, 1.0);
  EXPECT_EQ(scene.textures[0].width(), 200u);
}

TEST(RayMaterial, ValuesReplaceInheritedImages) {
  const SceneDescription scene = readStatements(
      "material = { diffuse = map(\"textures/polish.png\") } sphere {}"
      "sphere { material = { diffuse = (1, 0, 0) } }");
  EXPECT_EQ(materialOf(scene, 0).diffuse.texture, 0u);
  EXPECT_FALSE(materialOf(scene, 1).diffuse.texture.has_value());
}

/// The code and the text of the error, without the folder of the scenes.
std::string textureError(const std::string& statements, ErrorCode code) {
  try {
    static_cast<void>(readStatements(statements));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_EQ(error.file(), "test.ray");
    return error.what();
  }
  return "no error";
}

TEST(RayMaterial, ImagesThatCannotBeReadAreErrorsWhereTheyAreNamed) {
  EXPECT_EQ(textureError("sphere {\n material = { diffuse = map(\"textures/none.png\") } }",
                         ErrorCode::FileNotReadable),
            "test.ray:3:29: the texture \"textures/none.png\" cannot be read: there is no such "
            "file. Check the spelling and the folder you are in");
  EXPECT_EQ(textureError("material = { diffuse = map(textures) }", ErrorCode::FileNotReadable),
            "test.ray:2:28: the texture \"textures\" cannot be read: it is a folder, not a file. "
            "Name a file in it");
  EXPECT_EQ(textureError("material = { diffuse = map(\"spheres.ray\") }", ErrorCode::UnknownFormat),
            "test.ray:2:28: the texture \"spheres.ray\" cannot be read: it is no PNG, JPEG, BMP or "
            "TGA image. Convert it to PNG");
  if (std::filesystem::exists("/dev/zero")) {
    EXPECT_EQ(
        textureError("material = { diffuse = map(\"/dev/zero\") }", ErrorCode::FileNotReadable),
        "test.ray:2:28: the texture \"/dev/zero\" cannot be read: it is a device or a pipe, not a "
        "file. Name an image file");
  }
}

TEST(RayMaterial, HasNoValuesWithoutMeaning) {
  const auto index = [](const std::string& found) {
    return "test.ray:2:22: expected an index of refraction above 0, found \"" + found +
           "\". It can be neither negative nor 0";
  };
  EXPECT_EQ(errorOf("material = { index = 0 }"), index("0"));
  EXPECT_EQ(errorOf("material = { index = -1.5 }"), index("-1.5"));
  EXPECT_EQ(errorOf("material = { shininess = -1e-9 }"),
            "test.ray:2:26: expected a shininess of 0 or more, found \"-1e-9\". It cannot be "
            "negative");
  for (const std::string keyword :
       {"emissive", "ambient", "diffuse", "specular", "reflective", "transmissive"}) {
    EXPECT_EQ(errorOf("material = {\n" + keyword + "\n= (1, 0,\n -0.5) }"),
              "test.ray:5:2: expected a part of a colour of 0 or more, found \"-0.5\". It cannot "
              "be negative");
  }
  EXPECT_EQ(errorOf("material = { index = 0.01; shininess = 0; diffuse = (-0, 0, 2.5) }"),
            "no error");
}

TEST(RayMaterial, TellsWhatItExpects) {
  EXPECT_EQ(errorOf("material { }"),
            "test.ray:2:10: expected '=' behind \"material\", found '{'. Write material = ...");
  EXPECT_EQ(errorOf("material = (1, 0, 0)"),
            "test.ray:2:12: expected '{' or the name of a material, found '('. Write material = { "
            "... } or material = name");
  EXPECT_EQ(errorOf("material = { diffuse = 1 }"),
            "test.ray:2:24: expected a colour or a map, found \"1\". Write three numbers, (red, "
            "green, blue), or map(\"file.png\")");
  EXPECT_EQ(errorOf("material = { shininess = (1, 1, 1) }"),
            "test.ray:2:26: expected a number or a map, found '('. Write a number such as 1.5, or "
            "map(\"file.png\")");
  EXPECT_EQ(errorOf("material = { diffuse = map \"a.png\" }"),
            "test.ray:2:28: expected '(' behind \"map\", found the text \"a.png\". Write "
            "map(\"file.png\")");
  EXPECT_EQ(errorOf("material = { diffuse = map(.5) }"),
            "test.ray:2:28: expected the name of an image file, found \".5\". Write "
            "map(\"file.png\")");
  EXPECT_EQ(errorOf("material = { diffuse = map(a.png) }"),
            "test.ray:2:29: expected ')' behind the name of the image file, found \".png\". Write "
            "map(\"file.png\")");
  EXPECT_EQ(errorOf("material = { difuse = (1, 0, 0) }"),
            "test.ray:2:14: expected '}' or a keyword of \"material\", found \"difuse\". Did you "
            "mean \"diffuse\"?");
}

}  // namespace
}  // namespace planetree::test
