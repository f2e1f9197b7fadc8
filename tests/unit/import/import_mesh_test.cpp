#include "import/import_mesh.hpp"

#include "model_folder.hpp"
#include "sample_models.hpp"

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/vec3.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace planetree::test {
namespace {

using importing::importMesh;
using importing::ImportReport;

using ImportMesh = ModelFolder;

/// The box around the positions of some faces.
template <class T>
Box3 boundsOf(const TriangleMesh<T>& mesh, std::size_t firstFace, std::size_t faceCount) {
  Box3 bounds;
  for (std::size_t i = firstFace; i < firstFace + faceCount; ++i) {
    for (const std::uint32_t vertex : mesh.faces[i])
      bounds.extend(Vec3f(mesh.positions[vertex]));
  }
  return bounds;
}

void expectNear(const Box3& box, const Vec3f& lower, const Vec3f& upper) {
  // Rotations of glTF are quaternions of floats.
  constexpr float kTolerance = 1e-6f;
  for (const Axis axis : kAxes) {
    EXPECT_NEAR(box.lower[axis], lower[axis], kTolerance);
    EXPECT_NEAR(box.upper[axis], upper[axis], kTolerance);
  }
}

template <class T>
TriangleMesh<T> readSound(const std::filesystem::path& path, ImportReport& report) {
  TriangleMesh<T> mesh = importMesh<T>(path, &report);
  for (const FaceIndices& face : mesh.faces) {
    for (const std::uint32_t vertex : face)
      EXPECT_LT(vertex, mesh.positions.size());
  }
  return mesh;
}

/// `square.gltf` and its like: one square at x = 10, one of twice the size at z = 5.
void expectTwoSquares(const std::filesystem::path& path) {
  ImportReport report;
  const TriangleMesh<float> mesh = readSound<float>(path, report);
  EXPECT_EQ(report.formatName, "glTF2");
  EXPECT_EQ(report.format, MeshFormat::Other);
  EXPECT_EQ(report.polygonCount, 4u);
  ASSERT_EQ(mesh.faces.size(), 4u);
  EXPECT_EQ(mesh.positions.size(), 8u);
  expectNear(boundsOf(mesh, 0, 2), {10, 0, 0}, {11, 1, 0});
  expectNear(boundsOf(mesh, 2, 2), {-2, 0, 5}, {0, 2, 5});
}

TEST_F(ImportMesh, CutsThePolygonsOfAnOffFileIntoTriangles) {
  ImportReport report;
  const TriangleMesh<float> mesh = readSound<float>(write("cube.off", offCube()), report);
  EXPECT_EQ(report.formatName, "OFF");
  EXPECT_EQ(report.polygonCount, 6u);
  EXPECT_EQ(report.skippedPolygonCount, 0u);
  EXPECT_EQ(mesh.faces.size(), 12u);
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.sourceFace(11), 5u);
  expectNear(boundsOf(mesh, 0, 12), {0, 0, 0}, {1, 1, 1});
}

TEST_F(ImportMesh, PlacesTheMeshOfAGltfFileWhereEachOfItsNodesSays) {
  const std::string buffer = squareBuffer();
  expectTwoSquares(write("square.gltf", gltf(gltfNodes(), embedded(buffer), buffer.size())));
}

TEST_F(ImportMesh, ReadsTheBuffersBesideAGltfFile) {
  const std::string buffer = squareBuffer();
  static_cast<void>(write("numbers.bin", buffer));
  expectTwoSquares(write("square.gltf", gltf(gltfNodes(), "numbers.bin", buffer.size())));
}

TEST_F(ImportMesh, ReadsBinaryGltfFiles) {
  expectTwoSquares(write("square.glb", glb(gltfNodes(), squareBuffer())));
}

TEST_F(ImportMesh, GoesByTheContentOfFilesWithoutAName) {
  expectTwoSquares(write("square", glb(gltfNodes(), squareBuffer())));
  expectTwoSquares(write("square.obj", glb(gltfNodes(), squareBuffer())));
}

TEST_F(ImportMesh, ReadsColladaInMetresWithYUp) {
  ImportReport report;
  const TriangleMesh<double> mesh = readSound<double>(write("square.dae", collada()), report);
  EXPECT_EQ(report.formatName, "Collada");
  EXPECT_EQ(report.polygonCount, 2u);
  ASSERT_EQ(mesh.faces.size(), 4u);
  expectNear(boundsOf(mesh, 0, 2), {0, 0, -1}, {1, 0, 0});
  expectNear(boundsOf(mesh, 2, 2), {0, 7, -1}, {1, 7, 0});
}

TEST_F(ImportMesh, Reads3dStudioWithYUp) {
  ImportReport report;
  const TriangleMesh<float> mesh = readSound<float>(write("triangle.3ds", threeDStudio()), report);
  EXPECT_EQ(mesh.faces.size(), 1u);
  expectNear(boundsOf(mesh, 0, 1), {0, 0, -1}, {1, 0, 0});
}

TEST_F(ImportMesh, CountsPointsAndLines) {
  std::string nodes = gltfNodes();
  const std::string indices = "\"indices\": 1";
  const std::string buffer = squareBuffer();
  const auto readWithMode = [&](const std::string& mode, ImportReport& report) {
    std::string changed = nodes;
    changed.replace(changed.find(indices), indices.size(), indices + ", \"mode\": " + mode);
    return readSound<float>(write(mode + ".glb", glb(changed, buffer)), report);
  };
  ImportReport points;
  EXPECT_TRUE(readWithMode("0", points).faces.empty());
  EXPECT_EQ(points.unreadPrimitiveCount, 12u);
  ImportReport lines;
  EXPECT_TRUE(readWithMode("1", lines).faces.empty());
  EXPECT_EQ(lines.unreadPrimitiveCount, 6u);
}

TEST_F(ImportMesh, TellsWhatAssimpWarnsOf) {
  // Vertex 9 is none of the four; assimp drops the triangle itself, and says so.
  std::string buffer = squareBuffer();
  buffer[58] = 9;
  ImportReport report;
  const TriangleMesh<float> mesh =
      readSound<float>(write("square.glb", glb(gltfNodes(), buffer)), report);
  EXPECT_EQ(mesh.faces.size() + report.skippedPolygonCount, report.polygonCount);
  EXPECT_LT(mesh.faces.size(), 4u);
  ASSERT_FALSE(report.remarks.empty());
  EXPECT_NE(report.remarks.front().find("out-of-range"), std::string::npos);
  EXPECT_GE(report.remarkCount, report.remarks.size());
}

TEST_F(ImportMesh, KeepsVerticesThatAreNotFinite) {
  std::string buffer = squareBuffer();
  buffer.replace(0, 4, std::string("\0\0\xC0\x7F", 4));
  ImportReport report;
  const TriangleMesh<float> mesh =
      readSound<float>(write("square.glb", glb(gltfNodes(), buffer)), report);
  EXPECT_EQ(mesh.faces.size(), 4u);
  EXPECT_TRUE(std::any_of(mesh.positions.begin(), mesh.positions.end(),
                          [](const Vec3f& position) { return std::isnan(position.x); }));
}

TEST_F(ImportMesh, CountsCoordinatesThatAreTooLargeForFloatAlone) {
  std::string buffer = squareBuffer();
  buffer.replace(12, 4, std::string("\xFF\xFF\x7F\x7F", 4));  // the largest float; one is doubled
  const std::filesystem::path path = write("square.glb", glb(gltfNodes(), buffer));
  ImportReport inFloat;
  static_cast<void>(readSound<float>(path, inFloat));
  EXPECT_EQ(inFloat.tooLargeCount, 1u);
  ImportReport inDouble;
  static_cast<void>(readSound<double>(path, inDouble));
  EXPECT_EQ(inDouble.tooLargeCount, 0u);
}

TEST_F(ImportMesh, LeavesPlyStlAndObjToTheirOwnReaders) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n";
  for (const char* const name : {"model.obj", "model", "model.unheard"}) {
    ImportReport report;
    EXPECT_EQ(readSound<float>(write(name, obj), report).faces.size(), 1u) << name;
    EXPECT_EQ(report.formatName, "OBJ") << name;
    EXPECT_EQ(report.format, MeshFormat::Obj) << name;
    EXPECT_EQ(report.skippedPolygonCount, 1u) << name;
  }
}

TEST_F(ImportMesh, ReadsPipes) {
  const std::filesystem::path pipe = folder() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"; });
  ImportReport report;
  EXPECT_EQ(readSound<float>(pipe, report).faces.size(), 1u);
  writer.join();
}

TEST_F(ImportMesh, RefusesWhatIsNoReadableFile) {
  const auto expectFault = [&](const std::filesystem::path& path, ErrorCode code,
                               const std::string& words) {
    expectError([&] { return importMesh<float>(path); }, path, code, words);
  };
  expectFault(folder() / "none.glb", ErrorCode::FileNotReadable, "there is no such file");
  std::filesystem::create_directory(folder() / "folder.glb");
  expectFault(folder() / "folder.glb", ErrorCode::FileNotReadable, "it is a folder");
  expectFault(write("empty.glb", ""), ErrorCode::UnknownFormat, "the file is empty");
  expectFault(write("text.unheard", "Dear all,\n"), ErrorCode::UnknownFormat,
              "none of the formats");
  expectFault(write("text.ply", "Dear all,\n"), ErrorCode::UnknownFormat, "none of the formats");
  expectFault(write("packed.obj", "\x1F\x8B\x08"), ErrorCode::UnknownFormat, "Unpack it first");
}

TEST_F(ImportMesh, RefusesFilesWithoutPermission) {
  const std::filesystem::path path = write("secret.off", offCube());
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (std::ifstream(path).is_open())
    GTEST_SKIP() << "this user may read every file";
  expectError([&] { return importMesh<float>(path); }, path, ErrorCode::FileNotReadable,
              "no permission");
}

TEST_F(ImportMesh, TellsTheReasonThatAssimpGives) {
  const std::filesystem::path path = write("square.gltf", gltf(gltfNodes(), "gone.bin", 60));
  expectError([&] { return importMesh<float>(path); }, path, ErrorCode::MalformedFile,
              "could not open referenced file \"gone.bin\"");
}

TEST_F(ImportMesh, LeavesTheReportAloneWhereItThrows) {
  ImportReport report;
  report.formatName = "as it was";
  EXPECT_THROW(static_cast<void>(importMesh<float>(write("bad.dae", "<COLLADA"), &report)), Error);
  EXPECT_EQ(report.formatName, "as it was");
}

TEST_F(ImportMesh, MayBeCalledFromSeveralThreads) {
  const std::filesystem::path path = write("square.glb", glb(gltfNodes(), squareBuffer()));
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] { EXPECT_EQ(importMesh<float>(path).faces.size(), 4u); });
  }
  for (std::thread& thread : threads)
    thread.join();
}

}  // namespace
}  // namespace planetree::test
