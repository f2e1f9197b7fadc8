#include "import/model_material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

using importing::MaterialProperty;
using importing::ModelMaterial;
using scene::Material;

using Values = std::initializer_list<std::pair<MaterialProperty, Vec3d>>;
using Maps = std::initializer_list<std::pair<MaterialProperty, std::uint32_t>>;

constexpr Vec3d kWhite{1, 1, 1};
constexpr Vec3d kBlack{0, 0, 0};

Material translated(Values values, Maps maps = {},
                    const std::vector<scene::Texture>& textures = {}) {
  ModelMaterial material;
  for (const auto& [property, value] : values)
    material.values[static_cast<std::size_t>(property)] = value;
  for (const auto& [property, texture] : maps)
    material.textures[static_cast<std::size_t>(property)] = texture;
  return translateMaterial(material, textures);
}

Vec3d number(double x) {
  return {x, 0, 0};
}

void expectNear(const Vec3d& value, const Vec3d& expected) {
  constexpr double kTolerance = 1e-14;
  EXPECT_NEAR(value.x, expected.x, kTolerance);
  EXPECT_NEAR(value.y, expected.y, kTolerance);
  EXPECT_NEAR(value.z, expected.z, kTolerance);
}

TEST(TranslateMaterial, MakesGreyOfNothing) {
  const Material material = translated({});
  EXPECT_EQ(material.diffuse.value, kWhite * 0.6);
  EXPECT_EQ(material.ambient.value, kWhite * 0.6);
  EXPECT_EQ(material.specular.value, kBlack);
  EXPECT_EQ(material.reflective.value, kBlack);
  EXPECT_EQ(material.transmissive.value, kBlack);
}

TEST(TranslateMaterial, PassesClassicColoursOn) {
  const Material material = translated({{MaterialProperty::Ambient, {0.1, 0.2, 0.3}},
                                        {MaterialProperty::Diffuse, {0.4, 0.5, 0.6}},
                                        {MaterialProperty::Specular, {0.7, 0.8, 0.9}},
                                        {MaterialProperty::ShininessStrength, number(0.5)},
                                        {MaterialProperty::Shininess, number(30)},
                                        {MaterialProperty::Emissive, {0, 0.25, 0}},
                                        {MaterialProperty::Reflective, {0.5, 1, 0.5}},
                                        {MaterialProperty::Reflectivity, number(0.25)}});
  EXPECT_EQ(material.ambient.value, (Vec3d{0.1, 0.2, 0.3}));
  EXPECT_EQ(material.diffuse.value, (Vec3d{0.4, 0.5, 0.6}));
  EXPECT_EQ(material.specular.value, (Vec3d{0.35, 0.4, 0.45}));
  EXPECT_EQ(material.shininess.value, 30);
  EXPECT_EQ(material.emissive.value, (Vec3d{0, 0.25, 0}));
  EXPECT_EQ(material.reflective.value, (Vec3d{0.125, 0.25, 0.125}));
}

TEST(TranslateMaterial, LeavesOutHighlightsWithoutAnExponent) {
  EXPECT_EQ(translated({{MaterialProperty::Specular, kWhite}}).specular.value, kBlack);
}

TEST(TranslateMaterial, ReflectsOnlyByFilesThatSayHowMuch) {
  EXPECT_EQ(translated({{MaterialProperty::Reflective, kWhite}}).reflective.value, kBlack);
  EXPECT_EQ(translated({{MaterialProperty::Reflectivity, number(0.5)}}).reflective.value,
            kWhite * 0.5);
}

TEST(TranslateMaterial, FollowsTheIlluminationModelsOfMtl) {
  const auto withModel = [](double model, double opacity) {
    return translated({{MaterialProperty::Illumination, number(model)},
                       {MaterialProperty::Diffuse, kWhite},
                       {MaterialProperty::Specular, kWhite * 0.5},
                       {MaterialProperty::Transparent, {1, 0.5, 0.25}},
                       {MaterialProperty::RefractiveIndex, number(1.5)},
                       {MaterialProperty::Opacity, number(opacity)}});
  };
  // Which models reflect, with the colour of the highlight though it has no exponent.
  for (const double model : {1.0, 2.0, 10.0})
    EXPECT_EQ(withModel(model, 1).reflective.value, kBlack) << model;
  for (const double model : {3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0})
    EXPECT_EQ(withModel(model, 1).reflective.value, kWhite * 0.5) << model;
  // Which let light through although they are opaque: the filter says how much.
  for (const double model : {1.0, 2.0, 3.0, 4.0, 5.0, 8.0, 9.0})
    EXPECT_EQ(withModel(model, 1).transmissive.value, kBlack) << model;
  for (const double model : {6.0, 7.0})
    EXPECT_EQ(withModel(model, 1).transmissive.value, (Vec3d{1, 0.5, 0.25})) << model;
  // The others dissolve, without bending rays.
  const Material veil = withModel(2, 0.25);
  EXPECT_EQ(veil.transmissive.value, (Vec3d{0.75, 0.375, 0.1875}));
  EXPECT_EQ(veil.diffuse.value, kWhite * 0.25);
  EXPECT_EQ(veil.index.value, 1.0);
  EXPECT_EQ(withModel(4, 0.25).index.value, 1.5);
  EXPECT_EQ(withModel(7, 1).index.value, 1.5);
  // 0 is the colour as it is.
  const Material constant = withModel(0, 1);
  EXPECT_EQ(constant.emissive.value, kWhite);
  EXPECT_EQ(constant.diffuse.value, kBlack);
}

TEST(TranslateMaterial, TakesTheFilterOfOtherFormatsForNothing) {
  // What assimp calls transparent has a meaning of its own in each format.
  const Material material = translated(
      {{MaterialProperty::Transparent, kBlack}, {MaterialProperty::Opacity, number(0.5)}});
  EXPECT_EQ(material.transmissive.value, kWhite * 0.5);
}

TEST(TranslateMaterial, LetsMapsStandForThemselvesWhereTheColourIsBlack) {
  const Material material =
      translated({{MaterialProperty::Diffuse, kBlack}},
                 {{MaterialProperty::Diffuse, 3}, {MaterialProperty::Emissive, 4}});
  EXPECT_EQ(material.diffuse.value, kWhite);
  EXPECT_EQ(material.diffuse.texture, 3u);
  EXPECT_EQ(material.ambient.texture, 3u);
  EXPECT_EQ(material.emissive.value, kWhite);
  EXPECT_EQ(material.emissive.texture, 4u);
  // A physical model has no such habit: zero is zero.
  const Material physical =
      translated({{MaterialProperty::Metallic, number(0)}, {MaterialProperty::Emissive, kBlack}},
                 {{MaterialProperty::Emissive, 4}});
  EXPECT_EQ(physical.emissive.value, kBlack);
  EXPECT_FALSE(physical.emissive.texture.has_value());
}

TEST(TranslateMaterial, TakesTheDiffuseColourForAnAmbientOneThatIsBlack) {
  const Material material =
      translated({{MaterialProperty::Ambient, kBlack}, {MaterialProperty::Diffuse, {0.5, 0.25, 0}}},
                 {{MaterialProperty::Diffuse, 2}});
  EXPECT_EQ(material.ambient.value, (Vec3d{0.5, 0.25, 0}));
  EXPECT_EQ(material.ambient.texture, 2u);
}

TEST(TranslateMaterial, LetsMapsStandForThemselvesWhereThereIsNoColour) {
  EXPECT_EQ(translated({}, {{MaterialProperty::Diffuse, 0}}).diffuse.value, kWhite);
}

TEST(TranslateMaterial, ScattersRoughMetalAndMirrorsSmoothMetal) {
  const auto metal = [](double roughness) {
    return translated({{MaterialProperty::Diffuse, {1, 0.5, 0.25}},
                       {MaterialProperty::Metallic, number(1)},
                       {MaterialProperty::Roughness, number(roughness)}});
  };
  const Material rough = metal(1);
  EXPECT_EQ(rough.diffuse.value, (Vec3d{1, 0.5, 0.25}));
  EXPECT_EQ(rough.reflective.value, kBlack);
  EXPECT_EQ(rough.specular.value, kBlack);
  EXPECT_EQ(rough.shininess.value, 1.0);
  const Material smooth = metal(0);
  EXPECT_EQ(smooth.diffuse.value, kBlack);
  EXPECT_EQ(smooth.reflective.value, (Vec3d{1, 0.5, 0.25}));
  EXPECT_EQ(smooth.specular.value, (Vec3d{1, 0.5, 0.25}));  // never above 1
  EXPECT_EQ(smooth.shininess.value, 499.5);
  // In between what is scattered and what is mirrored add up to the colour.
  const Material half = metal(0.5);
  expectNear(half.diffuse.value + half.reflective.value, {1, 0.5, 0.25});
}

TEST(TranslateMaterial, GivesPlasticAFaintHighlightOfTheSameWidth) {
  const Material plastic = translated({{MaterialProperty::Diffuse, {1, 0, 0}},
                                       {MaterialProperty::Metallic, number(0)},
                                       {MaterialProperty::Roughness, number(0.5)}});
  EXPECT_EQ(plastic.diffuse.value, (Vec3d{1, 0, 0}));
  EXPECT_EQ(plastic.reflective.value, kBlack);
  expectNear(plastic.specular.value, kWhite * (0.04 * 0.25 * 16));
  EXPECT_EQ(plastic.shininess.value, 7.5);
}

TEST(TranslateMaterial, ShowsLinearColoursAsAPictureDoes) {
  const Material material = translated({{MaterialProperty::Diffuse, {0.0031308, 0.5, 1}},
                                        {MaterialProperty::Emissive, {0, 0.25, 0}},
                                        {MaterialProperty::LinearColour, number(1)},
                                        {MaterialProperty::Metallic, number(0)}});
  expectNear(material.diffuse.value, {0.0031308 * 12.92, 0.735356983052449, 1});
  expectNear(material.emissive.value, {0, 0.537098730483194, 0});
}

TEST(TranslateMaterial, BendsRaysOnlyInWhatIsSolid) {
  const auto glass = [](std::optional<double> index, double thickness) {
    ModelMaterial material;
    const auto set = [&](MaterialProperty property, double x) {
      material.values[static_cast<std::size_t>(property)] = number(x);
    };
    set(MaterialProperty::Metallic, 0);
    set(MaterialProperty::Roughness, 0);
    set(MaterialProperty::Transmission, 1);
    set(MaterialProperty::Thickness, thickness);
    if (index)
      set(MaterialProperty::RefractiveIndex, *index);
    return translateMaterial(material, {});
  };
  EXPECT_EQ(glass(std::nullopt, 0).index.value, 1.0);
  EXPECT_EQ(glass(std::nullopt, 2).index.value, 1.5);
  EXPECT_EQ(glass(1.33, 0).index.value, 1.33);
  EXPECT_EQ(glass(std::nullopt, 0).transmissive.value, kWhite);
  EXPECT_EQ(glass(std::nullopt, 0).diffuse.value, kBlack);
  expectNear(glass(std::nullopt, 0).reflective.value, kWhite * 0.04);
}

TEST(TranslateMaterial, TakesTheMeanOfMapsOfNumbers) {
  const std::vector<scene::Texture> textures = {
      scene::Texture(2, 1, {{0.0f, 0.25f, 1.0f}, {0.0f, 0.75f, 0.0f}})};
  const Material material =
      translated({{MaterialProperty::Metallic, number(1)}, {MaterialProperty::Diffuse, kWhite}},
                 {{MaterialProperty::Metallic, 0}, {MaterialProperty::Roughness, 0}}, textures);
  EXPECT_EQ(material.reflective.value, kWhite * 0.25);
  EXPECT_EQ(material.shininess.value, 7.5);
}

TEST(TranslateMaterial, ReadsTheOlderModelOfGlossiness) {
  const auto glossy = [](const Vec3d& specular) {
    return translated({{MaterialProperty::Diffuse, {0.5, 0.5, 0.5}},
                       {MaterialProperty::Specular, specular},
                       {MaterialProperty::Glossiness, number(1)},
                       {MaterialProperty::Metallic, number(1)}});
  };
  EXPECT_EQ(glossy(kWhite * 0.04).reflective.value, kBlack);
  EXPECT_EQ(glossy(kWhite * 0.04).diffuse.value, kWhite * 0.5);
  EXPECT_EQ(glossy({1, 0.5, 0}).reflective.value, (Vec3d{1, 0.5, 0}));
  EXPECT_EQ(glossy({1, 0.5, 0}).diffuse.value, kBlack);
}

}  // namespace
}  // namespace planetree::test
