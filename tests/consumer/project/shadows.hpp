#pragma once

#include <planetree/planetree.hpp>

/// Whether a sphere of radius 1 around the origin keeps the light from the point.
bool isInShadow(const planetree::Vec3f& point, const planetree::Vec3f& light);
