#include "ray_files/hit_table.hpp"

#include "ray_file.hpp"
#include "ray_files/npy_header.hpp"

#include <charconv>
#include <cstring>
#include <random>
#include <span>
#include <sstream>

namespace planetree::test {
namespace {

using tool::Occlusion;
using tool::TableFormat;

template <class T>
Hit<T> aHit() {
  Hit<T> hit;
  hit.t = T(0.1);
  hit.u = T(0.25);
  hit.v = T(1) / T(3);
  hit.normal = {T(0), T(-0.0), T(-1)};
  hit.geometry = 0;
  hit.primitive = 4'000'000;
  return hit;
}

template <class Answer>
std::string tableOf(TableFormat format, const std::vector<Answer>& answers) {
  std::string table = tool::tableHeader<Answer>(format, answers.size());
  tool::appendRows<Answer>(table, format, answers);
  return table;
}

TEST(HitTable, CsvHasAHeaderAndALineForEachRay) {
  EXPECT_EQ(tableOf<Hitf>(TableFormat::Csv, {aHit<float>(), Hitf{}}),
            "t,geometry,primitive,u,v,nx,ny,nz\n"
            "0.1,0,4000000,0.25,0.33333334,0,-0,-1\n"
            "inf,-1,-1,0,0,0,0,0\n");
  EXPECT_EQ(tableOf<Hitd>(TableFormat::Csv, {aHit<double>()}),
            "t,geometry,primitive,u,v,nx,ny,nz\n"
            "0.1,0,4000000,0.25,0.3333333333333333,0,-0,-1\n");
  EXPECT_EQ(tableOf<Occlusion>(TableFormat::Csv, {{true}, {false}}), "hit\n1\n0\n");
  EXPECT_EQ(tableOf<Hitf>(TableFormat::Csv, {}), "t,geometry,primitive,u,v,nx,ny,nz\n");
}

TEST(HitTable, ANumberedHitHasTheNumberOfItsRayInFront) {
  constexpr std::uint64_t kRay = 5'000'000'000;
  EXPECT_EQ(tableOf<tool::NumberedHit<float>>(TableFormat::Csv, {{kRay, aHit<float>()}}),
            "ray,t,geometry,primitive,u,v,nx,ny,nz\n"
            "5000000000,0.1,0,4000000,0.25,0.33333334,0,-0,-1\n");
  using Numbered = tool::NumberedHit<double>;
  const std::string table = tableOf<Numbered>(TableFormat::Npy, {{kRay, aHit<double>()}});
  const std::string plain = tableOf<Hitd>(TableFormat::Npy, {aHit<double>()});
  const std::string record =
      bytesOf<std::int64_t>({5'000'000'000}, std::endian::native) + plain.substr(plain.size() - 56);
  EXPECT_EQ(table.substr(table.size() - 64), record);
  EXPECT_NE(table.find("[('ray', '"), std::string::npos);
}

TEST(HitTable, NpyBytesAreThoseOfTheRecords) {
  const std::string table = tableOf<Hitf>(TableFormat::Npy, {aHit<float>(), Hitf{}});
  const std::size_t start = tool::tableHeader<Hitf>(TableFormat::Npy, 2).size();
  const Hitf hit = aHit<float>();
  const std::string first = bytesOf<float>({hit.t}, std::endian::native) +
                            bytesOf<std::int32_t>({0, 4'000'000}, std::endian::native) +
                            bytesOf<float>({hit.u, hit.v, 0.0f, -0.0f, -1.0f}, std::endian::native);
  EXPECT_EQ(table.substr(start, 32), first);
  const std::string miss =
      bytesOf<float>({std::numeric_limits<float>::infinity()}, std::endian::native) +
      bytesOf<std::int32_t>({-1, -1}, std::endian::native) +
      bytesOf<float>({0, 0, 0, 0, 0}, std::endian::native);
  EXPECT_EQ(table.substr(start + 32), miss);
  EXPECT_EQ(tableOf<Hitd>(TableFormat::Npy, {Hitd{}}).size(),
            tool::tableHeader<Hitd>(TableFormat::Npy, 1).size() + 56);
  EXPECT_EQ(tableOf<Occlusion>(TableFormat::Npy, {{true}, {false}})
                .substr(tool::tableHeader<Occlusion>(TableFormat::Npy, 2).size()),
            std::string("\1\0", 2));
}

/// The header as NumPy lays it down: magic, version 1.0, length, dictionary, padding, line end.
template <class Answer>
void expectWellFormedHeader(const std::string& type) {
  for (const std::uint64_t count :
       {std::uint64_t{0}, std::uint64_t{123'456'789}, std::numeric_limits<std::uint64_t>::max()}) {
    const std::string header = tool::tableHeader<Answer>(TableFormat::Npy, count);
    EXPECT_EQ(header.size(), tool::tableHeader<Answer>(TableFormat::Npy, 7).size())
        << "a header must fit over another one";
    EXPECT_EQ(header.size() % 64, 0u);
    EXPECT_EQ(header.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const auto low = static_cast<unsigned char>(header[8]);
    const auto high = static_cast<unsigned char>(header[9]);
    EXPECT_EQ(header.size(), 10u + low + 256u * high);
    EXPECT_EQ(header.back(), '\n');
    EXPECT_NE(header.find("{'descr': [" + type + "], 'fortran_order': False, 'shape': (" +
                          std::to_string(count) + ",), } "),
              std::string::npos)
        << header;
    const tool::NpyHeader parsed = tool::parseNpyHeader(header.substr(10), "header");
    EXPECT_EQ(parsed.type, "");
    EXPECT_EQ(parsed.shape, std::vector<std::uint64_t>{count});
  }
}

TEST(HitTable, NpyHeadersAreWellFormedAndOfOneLength) {
  if (std::endian::native != std::endian::little)
    GTEST_SKIP() << "the types below are those of a little-endian machine";
  expectWellFormedHeader<Hitf>(
      "('t', '<f4'), ('geometry', '<i4'), ('primitive', '<i4'), ('u', '<f4'), ('v', '<f4'), "
      "('nx', '<f4'), ('ny', '<f4'), ('nz', '<f4')");
  expectWellFormedHeader<Hitd>(
      "('t', '<f8'), ('geometry', '<i4'), ('primitive', '<i4'), ('u', '<f8'), ('v', '<f8'), "
      "('nx', '<f8'), ('ny', '<f8'), ('nz', '<f8')");
  expectWellFormedHeader<Occlusion>("('hit', '|b1')");
}

/// A random number of any magnitude that is not a NaN.
template <class T, class Bits>
T randomNumber(std::mt19937_64& generator) {
  while (true) {
    const T number = std::bit_cast<T>(static_cast<Bits>(generator()));
    if (number == number)
      return number;
  }
}

template <class T, class Bits>
void expectExactCsvRoundTrip(std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 generator(seed);
  std::vector<Hit<T>> hits(2000);
  for (Hit<T>& hit : hits) {
    for (T* number : {&hit.t, &hit.u, &hit.v, &hit.normal.x, &hit.normal.y, &hit.normal.z})
      *number = randomNumber<T, Bits>(generator);
    hit.geometry = static_cast<std::uint32_t>(generator() >> 33);
    hit.primitive = static_cast<std::uint32_t>(generator() >> 33);
  }
  std::istringstream lines(tableOf<Hit<T>>(TableFormat::Csv, hits));
  std::string line;
  std::getline(lines, line);
  for (const Hit<T>& hit : hits) {
    ASSERT_TRUE(std::getline(lines, line));
    std::vector<std::string> fields;
    std::istringstream columns(line);
    for (std::string field; std::getline(columns, field, ',');)
      fields.push_back(field);
    ASSERT_EQ(fields.size(), 8u);
    const std::vector<T> written = {hit.t, hit.u, hit.v, hit.normal.x, hit.normal.y, hit.normal.z};
    const std::vector<std::size_t> places = {0, 3, 4, 5, 6, 7};
    for (std::size_t i = 0; i < written.size(); ++i) {
      const std::string& field = fields[places[i]];
      T read{};
      std::from_chars(field.data(), field.data() + field.size(), read);
      ASSERT_TRUE(haveSameBits(read, written[i])) << field;
    }
    EXPECT_EQ(fields[1], std::to_string(hit.geometry));
    EXPECT_EQ(fields[2], std::to_string(hit.primitive));
  }
}

TEST(HitTable, CsvIsReadBackToTheLastBit) {
  expectExactCsvRoundTrip<float, std::uint32_t>(1);
  expectExactCsvRoundTrip<double, std::uint64_t>(2);
}

}  // namespace
}  // namespace planetree::test
