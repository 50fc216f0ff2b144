// Parametric geometries in scene files: three.js's constructor calls by name.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"
#include "three/resource_writer.hpp"
#include "three/scene_library.hpp"

#include <algorithm>
#include <numbers>
#include <span>
#include <stdexcept>

namespace THREE {

namespace {

constexpr double pi = std::numbers::pi;
using Values = std::vector<double>;
using Made = std::shared_ptr<BufferGeometry>;

struct Parameter {
    const char* name;
    double otherwise;  // three.js r146's default
};

struct Parametric {
    const char* type;
    std::span<const Parameter> parameters;  // in the order of the constructor
    Made (*make)(const Values& v);
};

constexpr Parameter box[] = {{"width", 1},         {"height", 1},         {"depth", 1},
                             {"widthSegments", 1}, {"heightSegments", 1}, {"depthSegments", 1}};
constexpr Parameter sphere[] = {{"radius", 1},      {"widthSegments", 32}, {"heightSegments", 16},
                                {"phiStart", 0},    {"phiLength", 2 * pi}, {"thetaStart", 0},
                                {"thetaLength", pi}};
constexpr Parameter plane[] = {{"width", 1}, {"height", 1}, {"widthSegments", 1}, {"heightSegments", 1}};
constexpr Parameter torus[] = {
    {"radius", 1}, {"tube", 0.4}, {"radialSegments", 8}, {"tubularSegments", 6}, {"arc", 2 * pi}};
constexpr Parameter torusKnot[] = {{"radius", 1},         {"tube", 0.4}, {"tubularSegments", 64},
                                   {"radialSegments", 8}, {"p", 2},      {"q", 3}};
constexpr Parameter cylinder[] = {{"radiusTop", 1},      {"radiusBottom", 1},    {"height", 1},
                                  {"radialSegments", 8}, {"heightSegments", 1},  {"openEnded", 0},
                                  {"thetaStart", 0},     {"thetaLength", 2 * pi}};
constexpr Parameter cone[] = {{"radius", 1},          {"height", 1},    {"radialSegments", 8},
                              {"heightSegments", 1},  {"openEnded", 0}, {"thetaStart", 0},
                              {"thetaLength", 2 * pi}};

Made makeBox(const Values& v) { return std::make_shared<BoxGeometry>(v[0], v[1], v[2], v[3], v[4], v[5]); }
Made makeSphere(const Values& v) {
    return std::make_shared<SphereGeometry>(v[0], v[1], v[2], v[3], v[4], v[5], v[6]);
}
Made makePlane(const Values& v) { return std::make_shared<PlaneGeometry>(v[0], v[1], v[2], v[3]); }
Made makeTorus(const Values& v) { return std::make_shared<TorusGeometry>(v[0], v[1], v[2], v[3], v[4]); }
Made makeTorusKnot(const Values& v) {
    return std::make_shared<TorusKnotGeometry>(v[0], v[1], v[2], v[3], v[4], v[5]);
}
Made makeCylinder(const Values& v) {
    return std::make_shared<CylinderGeometry>(v[0], v[1], v[2], v[3], v[4], v[5] != 0, v[6], v[7]);
}
// A cone is a cylinder with nothing on top: the same vertices as three.js's own ConeGeometry.
Made makeCone(const Values& v) {
    return std::make_shared<CylinderGeometry>(0, v[0], v[1], v[2], v[3], v[4] != 0, v[5], v[6]);
}

constexpr Parametric table[] = {
    {"BoxGeometry", box, makeBox},
    {"SphereGeometry", sphere, makeSphere},
    {"PlaneGeometry", plane, makePlane},
    {"TorusGeometry", torus, makeTorus},
    {"TorusKnotGeometry", torusKnot, makeTorusKnot},
    {"CylinderGeometry", cylinder, makeCylinder},
    {"ConeGeometry", cone, makeCone},
};

const Parametric* find(const std::string& type) {
    for (const Parametric& candidate : table)
        if (type == candidate.type)
            return &candidate;
    return nullptr;
}

// "BoxBufferGeometry" is what three.js called BoxGeometry until r125.
std::string modernName(std::string type) {
    const std::size_t old = type.find("BufferGeometry");
    if (old != std::string::npos && old > 0)
        type.erase(old, std::string("Buffer").size());
    return type;
}

}  // namespace

Made loadParametric(const Node& node, const std::string& type) {
    const Parametric* const found = find(modernName(type));
    if (found == nullptr)
        return nullptr;
    Values values;
    for (const Parameter& parameter : found->parameters) {
        const bool isFlag = std::string(parameter.name) == "openEnded";
        values.push_back(isFlag ? (node.boolean(parameter.name, false) ? 1.0 : 0.0)
                                : node.number(parameter.name, parameter.otherwise));
    }
    try {
        return found->make(values);
    } catch (const std::invalid_argument& e) {
        node.refuse(e.what());
    }
}

bool isAsConstructed(const BufferGeometry& geometry) {
    const Parametric* const found = find(geometry.type());
    const auto parameters = geometry.parameters();
    if (found == nullptr || parameters.size() != found->parameters.size())
        return false;
    Values values;
    for (const auto& [name, value] : parameters)
        values.push_back(value);
    const Made fresh = found->make(values);
    const auto sameAttribute = [](const auto& a, const auto& b) {
        return a.first == b.first && a.second.itemSize == b.second.itemSize &&
               a.second.array == b.second.array;
    };
    return geometry.index == fresh->index &&
           std::equal(geometry.attributes.begin(), geometry.attributes.end(), fresh->attributes.begin(),
                      fresh->attributes.end(), sameAttribute);
}

}  // namespace THREE
