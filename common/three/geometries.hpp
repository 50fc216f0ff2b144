// The parametric geometries: three.js r146's parameters, defaults, vertex order and triangles.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"

#include <numbers>

namespace THREE {

/// A box about the origin, each side divided into segments; six faces with normals of their own.
/// https://threejs.org/docs/#api/en/geometries/BoxGeometry
class BoxGeometry : public BufferGeometry {
  public:
    /// Sizes in object units; segments are whole numbers, at least 1 (fractions are dropped, as three.js does).
    explicit BoxGeometry(double width = 1, double height = 1, double depth = 1, double widthSegments = 1,
                         double heightSegments = 1, double depthSegments = 1);
    const char* type() const override { return "BoxGeometry"; }
    std::vector<std::pair<std::string, double>> parameters() const override { return parameters_; }

  private:
    std::vector<std::pair<std::string, double>> parameters_;
};

/// A sphere about the origin, poles on the y axis, in rings of quads.
/// https://threejs.org/docs/#api/en/geometries/SphereGeometry
class SphereGeometry : public BufferGeometry {
  public:
    /// At least 3 segments round and 2 from pole to pole; angles in radians.
    explicit SphereGeometry(double radius = 1, double widthSegments = 32, double heightSegments = 16,
                            double phiStart = 0, double phiLength = 2 * std::numbers::pi,
                            double thetaStart = 0, double thetaLength = std::numbers::pi);
    const char* type() const override { return "SphereGeometry"; }
    std::vector<std::pair<std::string, double>> parameters() const override { return parameters_; }

  private:
    std::vector<std::pair<std::string, double>> parameters_;
};

/// A rectangle in the xy plane about the origin, facing +z.
/// https://threejs.org/docs/#api/en/geometries/PlaneGeometry
class PlaneGeometry : public BufferGeometry {
  public:
    explicit PlaneGeometry(double width = 1, double height = 1, double widthSegments = 1,
                           double heightSegments = 1);
    const char* type() const override { return "PlaneGeometry"; }
    std::vector<std::pair<std::string, double>> parameters() const override { return parameters_; }

  private:
    std::vector<std::pair<std::string, double>> parameters_;
};

/// A ring in the xy plane: `radius` to the middle of the tube, `tube` its own radius.
/// https://threejs.org/docs/#api/en/geometries/TorusGeometry
class TorusGeometry : public BufferGeometry {
  public:
    explicit TorusGeometry(double radius = 1, double tube = 0.4, double radialSegments = 8,
                           double tubularSegments = 6, double arc = 2 * std::numbers::pi);
    const char* type() const override { return "TorusGeometry"; }
    std::vector<std::pair<std::string, double>> parameters() const override { return parameters_; }

  private:
    std::vector<std::pair<std::string, double>> parameters_;
};

/// A torus knot: winds p times about its axis of symmetry and q times about a circle inside the torus.
/// https://threejs.org/docs/#api/en/geometries/TorusKnotGeometry
class TorusKnotGeometry : public BufferGeometry {
  public:
    explicit TorusKnotGeometry(double radius = 1, double tube = 0.4, double tubularSegments = 64,
                               double radialSegments = 8, double p = 2, double q = 3);
    const char* type() const override { return "TorusKnotGeometry"; }
    std::vector<std::pair<std::string, double>> parameters() const override { return parameters_; }

  private:
    std::vector<std::pair<std::string, double>> parameters_;
};

/// A cylinder or cone about the y axis, with caps unless `openEnded`.
/// https://threejs.org/docs/#api/en/geometries/CylinderGeometry
class CylinderGeometry : public BufferGeometry {
  public:
    explicit CylinderGeometry(double radiusTop = 1, double radiusBottom = 1, double height = 1,
                              double radialSegments = 8, double heightSegments = 1, bool openEnded = false,
                              double thetaStart = 0, double thetaLength = 2 * std::numbers::pi);
    const char* type() const override { return "CylinderGeometry"; }
    std::vector<std::pair<std::string, double>> parameters() const override { return parameters_; }

  private:
    std::vector<std::pair<std::string, double>> parameters_;
};

/// More vertices than this are refused by every loader: beyond it a frame no longer fits ordinary memory.
inline constexpr double maxVertices = 50'000'000;
/// More than this are refused by the geometries above (std::invalid_argument that names the parameters), and by a loader for
/// all of a file's together. Lower, because a few digits make them: a wrong one must not take the machine down.
inline constexpr double maxParametricVertices = 5'000'000;

}  // namespace THREE
