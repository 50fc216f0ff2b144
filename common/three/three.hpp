// Everything of the scene API: what `import * as THREE from 'three'` is in a lesson.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"
#include "three/color.hpp"
#include "three/geometries.hpp"
#include "three/lights.hpp"
#include "three/materials.hpp"
#include "three/matrix4.hpp"
#include "three/object3d.hpp"
#include "three/rotation.hpp"
#include "three/scene.hpp"
#include "three/vector3.hpp"
