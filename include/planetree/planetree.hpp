#pragma once

/// Everything but reading files (mesh/read_mesh.hpp, in the target planetree::io).
#include <planetree/batch/batch_options.hpp>
#include <planetree/batch/ray_arrays.hpp>
#include <planetree/batch/trace_batch.hpp>
#include <planetree/build_tree.hpp>
#include <planetree/error.hpp>
#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/rounding.hpp>
#include <planetree/geometry/vec3.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/hit/next_ray.hpp>
#include <planetree/kd_tree.hpp>
#include <planetree/mesh/face.hpp>
#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/object.hpp>
#include <planetree/scene.hpp>
#include <planetree/shape/shapes.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/build_report.hpp>
#include <planetree/split/find_best_split_plane.hpp>
#include <planetree/split/scene_range.hpp>
#include <planetree/traversal/instruction_set.hpp>
