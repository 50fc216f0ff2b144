// BufferGeometry: the vertices and triangles of a mesh (slide 34).
// SPDX-License-Identifier: MIT
#pragma once

#include "three/resource.hpp"
#include "three/vector3.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace THREE {

/// One attribute of every vertex: `itemSize` numbers each, one vertex after the other.
/// https://threejs.org/docs/#api/en/core/BufferAttribute
struct BufferAttribute {
    std::vector<double> array;  ///< count() x itemSize numbers; rounded to float on the way to the GPU
    int itemSize = 3;  ///< numbers per vertex, at least 1

    /// Whole vertices; 0 if itemSize is below 1.
    std::size_t count() const { return itemSize < 1 ? 0 : array.size() / static_cast<std::size_t>(itemSize); }
    double getX(std::size_t vertex) const { return array[vertex * static_cast<std::size_t>(itemSize)]; }
    double getY(std::size_t vertex) const { return array[vertex * static_cast<std::size_t>(itemSize) + 1]; }
    double getZ(std::size_t vertex) const { return array[vertex * static_cast<std::size_t>(itemSize) + 2]; }
    /// The first three numbers of a vertex; itemSize must be 3 or more.
    Vector3 getXYZ(std::size_t vertex) const { return {getX(vertex), getY(vertex), getZ(vertex)}; }
};

/// An axis-aligned box in object space; empty (min > max) for a geometry without vertices.
struct Box3 {
    Vector3 min{1, 1, 1};
    Vector3 max{-1, -1, -1};
    bool isEmpty() const { return min.x > max.x; }
};

/// A sphere in object space; radius < 0 for a geometry without vertices, as in three.js.
struct Sphere {
    Vector3 center;
    double radius = -1;
};

/// Vertices with attributes ("position", "normal", "uv") and, if `index` is not empty, triangles of three
/// indices each; without an index every three vertices are a triangle. Counter-clockwise seen from the front.
/// https://threejs.org/docs/#api/en/core/BufferGeometry
class BufferGeometry : public Resource {
  public:
    std::map<std::string, BufferAttribute> attributes;  ///< by three.js's names; object space
    std::vector<std::uint32_t> index;  ///< three per triangle, or empty

    /// three.js's class name, as in its JSON.
    virtual const char* type() const { return "BufferGeometry"; }
    /// The numbers of the constructor call by three.js's names, in its order; empty for a plain
    /// BufferGeometry.
    virtual std::vector<std::pair<std::string, double>> parameters() const { return {}; }

    /// Throws std::invalid_argument unless itemSize is at least 1 and the array holds whole vertices.
    BufferGeometry& setAttribute(const std::string& attribute, std::vector<double> array, int itemSize);
    BufferGeometry& setIndex(std::vector<std::uint32_t> indices);
    /// Null if there is none of this name.
    const BufferAttribute* getAttribute(const std::string& attribute) const;
    /// Say so after writing into attributes or index by hand, so that they are uploaded again (three.js:
    /// needsUpdate).
    void needsUpdate() { ++version_; }
    /// Grows with every change made through setAttribute, setIndex, computeVertexNormals and needsUpdate.
    std::uint64_t version() const { return version_; }

    /// Vertices of "position"; 0 without it.
    std::size_t vertexCount() const;
    /// Whole triangles; one or two indices (or vertices) left over at the end are none.
    std::size_t triangleCount() const;
    /// The three vertex numbers of a triangle, with or without an index, as they stand: they may lie beyond
    /// the vertices. Throws std::out_of_range from triangleCount() on.
    void triangle(std::size_t number, std::uint32_t (&vertices)[3]) const;

    /// Normals from the triangles around each vertex, weighted by area, as three.js's; collinear triangles
    /// count nothing, and edges from 1e-100 to 1e100 give unit normals. A vertex of no triangle gets (0,0,0).
    /// Throws std::out_of_range for an index beyond the vertices, std::invalid_argument if "position" has
    /// fewer than three numbers per vertex; nothing is changed then. The same holds for toFaces.
    void computeVertexNormals();
    /// The same surface with three vertices of its own per triangle and the triangle's own normal at each:
    /// what `flatShading` draws (three.js: toNonIndexed, then computeVertexNormals). A degenerate triangle's
    /// is (0,0,0). `faces` may be this geometry. Every attribute needs as many vertices as "position"
    /// (std::invalid_argument).
    void toFaces(BufferGeometry& faces) const;
    /// Of all vertices, used by a triangle or not; a coordinate that is not a number is passed over.
    Box3 computeBoundingBox() const;
    /// Centre of the bounding box, radius to the farthest vertex, as three.js's.
    Sphere computeBoundingSphere() const;
    /// The same two, computed once per version.
    const Box3& boundingBox() const {
        updateBounds();
        return box_;
    }
    const Sphere& boundingSphere() const {
        updateBounds();
        return sphere_;
    }
    /// Whether no back of a triangle is seen from outside: it is closed, its triangles face outwards, and it crosses itself nowhere.
    /// Known of solids whose edges are all convex (several will do) and of whole tori and knots with a tube of their own width;
    /// false for all others, and above 100,000 triangles. Found out once per version.
    bool hidesItsBacks() const;

    /// For validate(): the version whose numbers were last found good, so that a still geometry is read once.
    std::uint64_t validatedVersion() const { return validatedVersion_; }
    void markValidated() const { validatedVersion_ = version_; }

  protected:
    /// For constructors: the surface as it is now does not cross itself.
    void meetsItselfNowhere() { simpleVersion_ = version_; }

    std::uint64_t version_ = 1;

  private:
    void updateBounds() const {
        if (boundsVersion_ == version_)
            return;
        box_ = computeBoundingBox();
        sphere_ = computeBoundingSphere();
        boundsVersion_ = version_;
    }

    mutable Box3 box_;
    mutable Sphere sphere_;
    mutable std::uint64_t boundsVersion_ = 0;
    std::uint64_t simpleVersion_ = 0;
    mutable std::uint64_t solidVersion_ = 0;
    mutable bool solid_ = false;
    mutable std::uint64_t validatedVersion_ = 0;
};

}  // namespace THREE
