// Meshes and lights of two scenes, paired and compared.
// SPDX-License-Identifier: MIT
#include "grader/judge/scene_difference.hpp"

#include "lighting/reference/geometry.hpp"
#include "three/lights.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace grader {

namespace {

using glm::dvec3;
using lighting::reference::unit;
using Place = lighting::reference::Place<double>;

constexpr double near = 1e-4;  // relative: far below what 1/255 of a picture shows

dvec3 vec(const THREE::Color& c) { return {c.r, c.g, c.b}; }
double largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
bool same(const dvec3& a, const dvec3& b) { return largest(a - b) <= near * std::max(1.0, largest(a)); }
bool same(double a, double b) { return std::abs(a - b) <= near * std::max(1.0, std::abs(a)); }

std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g", x + 0.0);
    return buffer;
}
std::string text(const dvec3& v) { return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")"; }
std::string text(bool yes) { return yes ? "true" : "false"; }

struct Body {
    const THREE::Mesh* mesh;
    Place place;
    dvec3 scale;  // lengths of the axes, the first negative in a mirror
    dvec3 size;  // of the geometry's box, object space
};

struct Light {
    dvec3 place;  // position, or unit direction towards the light
    dvec3 L;
    double decay = 0, distance = 0;
};

struct Contents {
    std::vector<Body> bodies;
    std::vector<Light> suns, bulbs;
    dvec3 ambient{0};
    dvec3 background{0};
};

dvec3 sizeOf(const THREE::BufferGeometry& geometry) {
    dvec3 low(1e300), high(-1e300);
    const auto* positions = geometry.getAttribute("position");
    if (positions == nullptr)
        return dvec3(0);
    for (std::size_t i = 0; i < positions->count(); ++i) {
        const dvec3 p(positions->getXYZ(i));
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return high - low;
}

// Two lamps at one place are one brighter lamp.
void addLight(std::vector<Light>& lights, const Light& light) {
    for (Light& one : lights)
        if (same(one.place, light.place) && same(one.decay, light.decay) &&
            same(one.distance, light.distance)) {
            one.L += light.L;
            return;
        }
    lights.push_back(light);
}

void addMesh(Contents& contents, const THREE::Mesh& mesh) {
    if (!mesh.geometry || !mesh.material || !mesh.material->visible)
        return;
    const Place place = lighting::reference::placeOf<double>(mesh);
    const double sign = place.determinant() < 0 ? -1 : 1;
    contents.bodies.push_back({&mesh, place,
                               dvec3(sign * glm::length(place.x), glm::length(place.y), glm::length(place.z)),
                               sizeOf(*mesh.geometry)});
}

Contents contentsOf(const THREE::Scene& scene) {
    Contents all;
    if (scene.background)
        all.background = vec(*scene.background);
    scene.traverseVisible([&](const THREE::Object3D& object) {
        const dvec3 origin = lighting::reference::placeOf<double>(object).origin;
        if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object))
            addMesh(all, *mesh);
        else if (const auto* sun = dynamic_cast<const THREE::DirectionalLight*>(&object)) {
            const dvec3 target = lighting::reference::placeOf<double>(sun->target).origin;
            addLight(all.suns, {unit(origin - target), vec(sun->radiance())});
        } else if (const auto* bulb = dynamic_cast<const THREE::PointLight*>(&object))
            addLight(all.bulbs, {origin, vec(bulb->radiance()), bulb->decay, bulb->distance});
        else if (const auto* ambient = dynamic_cast<const THREE::AmbientLight*>(&object))
            all.ambient += vec(ambient->radiance());
    });
    return all;
}

// Pairs each of `expected` with the nearest of `found` that is still free, nearest pairs first.
template <class T, class Distance>
std::vector<const T*> pairs(const std::vector<T>& expected, const std::vector<T>& found,
                            const Distance& distance) {
    struct Pair {
        double distance;
        std::size_t i, j;
    };
    std::vector<Pair> all;
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t j = 0; j < found.size(); ++j)
            all.push_back({distance(expected[i], found[j]), i, j});
    std::stable_sort(all.begin(), all.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    std::vector<const T*> result(expected.size(), nullptr);
    std::vector<bool> taken(found.size(), false);
    for (const Pair& pair : all)
        if (result[pair.i] == nullptr && !taken[pair.j]) {
            result[pair.i] = &found[pair.j];
            taken[pair.j] = true;
        }
    return result;
}

// Collects aspects under one prefix: "point[0]".
class Writer {
  public:
    Writer(Aspects& aspects, std::string prefix) : aspects_(aspects), prefix_(std::move(prefix)) {}
    template <class T>
    void value(const char* name, const T& expected, const T& found) {
        put(name, same(expected, found), text(found));
    }
    void flag(const char* name, bool expected, bool found) { put(name, expected == found, text(found)); }
    void put(const char* name, bool right, const std::string& found) {
        aspects_[prefix_ + "." + name] = {right, found};
    }
    /// What is not there has nothing right.
    void missing(std::initializer_list<const char*> names) {
        put("present", false, "none");
        for (const char* name : names)
            put(name, false, "none");
    }
    void light(const dvec3& expected, const dvec3& found) {
        const double brightest = std::max(largest(found), 1e-300);
        put("color",
            same(expected / std::max(largest(expected), 1e-300), found / brightest) || largest(found) == 0,
            text(found / brightest));
        value("intensity", largest(expected), largest(found));
    }

  private:
    Aspects& aspects_;
    std::string prefix_;
};

std::string numbered(const char* kind, std::size_t i) {
    return std::string(kind) + "[" + std::to_string(i) + "]";
}

void compareMaterials(Writer& writer, const THREE::Material& expected, const THREE::Material& found) {
    writer.put("material", std::string(expected.type()) == found.type(), found.type());
    writer.value("color", vec(expected.color), vec(found.color));
    writer.flag("flat", expected.flatShading, found.flatShading);
    writer.put("side", expected.side == found.side, text(static_cast<double>(found.side)));
    writer.value("emissive", vec(expected.emitted()), vec(found.emitted()));
    const auto* shiny = dynamic_cast<const THREE::MeshPhongMaterial*>(&expected);
    const auto* other = dynamic_cast<const THREE::MeshPhongMaterial*>(&found);
    if (shiny == nullptr)
        return;
    writer.value("specular", vec(shiny->specular), other == nullptr ? dvec3(0) : vec(other->specular));
    writer.value("shininess", shiny->shininess, other == nullptr ? 0.0 : other->shininess);
}

double apartness(const Body& a, const Body& b) {
    return glm::length(a.place.origin - b.place.origin) + glm::length(a.scale - b.scale) +
           10 * glm::length(a.size - b.size);
}

void compareMeshes(Aspects& aspects, const Contents& expected, const Contents& found) {
    const auto partners = pairs(expected.bodies, found.bodies, apartness);
    for (std::size_t i = 0; i < partners.size(); ++i) {
        Writer writer(aspects, numbered("mesh", i));
        const Body& a = expected.bodies[i];
        if (partners[i] == nullptr) {
            writer.missing({"geometry", "place", "scale", "material", "color", "flat"});
            continue;
        }
        const Body& b = *partners[i];
        writer.put("present", true, "");
        const auto *before = a.mesh->geometry->getAttribute("position"),
                   *after = b.mesh->geometry->getAttribute("position");
        writer.put("geometry",
                   same(a.size, b.size) && before != nullptr && after != nullptr &&
                       before->count() == after->count(),
                   text(b.size));
        writer.put("place",
                   same(a.place.origin, b.place.origin) && same(unit(a.place.y), unit(b.place.y)) &&
                       same(unit(a.place.z), unit(b.place.z)),
                   text(b.place.origin));
        writer.value("scale", a.scale, b.scale);
        compareMaterials(writer, *a.mesh->material, *b.mesh->material);
    }
}

// A lamp that gives no light is the last to be taken for one.
double apart(const Light& a, const Light& b) {
    return glm::length(a.place - b.place) + (b.L == dvec3(0) ? 1e300 : 0);
}
std::size_t shining(const std::vector<Light>& lights) {
    return static_cast<std::size_t>(
        std::count_if(lights.begin(), lights.end(), [](const Light& one) { return one.L != dvec3(0); }));
}

void compareSuns(Aspects& aspects, const Contents& expected, const Contents& found) {
    const auto partners = pairs(expected.suns, found.suns, apart);
    for (std::size_t i = 0; i < partners.size(); ++i) {
        Writer writer(aspects, numbered("directional", i));
        if (partners[i] == nullptr) {
            writer.missing({"direction", "color", "intensity"});
            continue;
        }
        writer.put("present", true, "");
        writer.value("direction", expected.suns[i].place, partners[i]->place);
        writer.light(expected.suns[i].L, partners[i]->L);
    }
}

void compareBulbs(Aspects& aspects, const Contents& expected, const Contents& found) {
    const auto partners = pairs(expected.bulbs, found.bulbs, apart);
    for (std::size_t i = 0; i < partners.size(); ++i) {
        Writer writer(aspects, numbered("point", i));
        if (partners[i] == nullptr) {
            writer.missing({"position", "color", "intensity", "decay", "distance"});
            continue;
        }
        const Light &a = expected.bulbs[i], &b = *partners[i];
        writer.put("present", true, "");
        writer.value("position", a.place, b.place);
        writer.light(a.L, b.L);
        writer.value("decay", a.decay, b.decay);
        writer.value("distance", a.distance, b.distance);
    }
}

void compareAmbient(Aspects& aspects, const dvec3& expected, const dvec3& found) {
    Writer writer(aspects, "ambient");
    if (largest(expected) == 0) {
        writer.put("extra", largest(found) == 0, text(found));
        return;
    }
    writer.put("present", largest(found) > 0, text(largest(found) > 0));
    writer.light(expected, found);
    if (largest(found) == 0)
        writer.put("color", false, "none");
}

void compareCounts(Aspects& aspects, const char* kind, std::size_t expected, std::size_t found) {
    aspects[std::string(kind) + ".extra"] = {found <= expected, text(static_cast<double>(found))};
}

// A range in brackets, "[1-12]", against a number in brackets, "[7]"; how many characters of each it took, if it fits.
std::optional<std::pair<std::size_t, std::size_t>> range(const char* pattern, const char* name) {
    int low = 0, high = 0, number = 0, taken = 0, read = 0;
    if (std::sscanf(pattern, "[%d-%d]%n", &low, &high, &taken) != 2 || taken == 0 ||
        std::sscanf(name, "[%d]%n", &number, &read) != 1 || read == 0 || number < low || number > high)
        return std::nullopt;
    return std::pair(static_cast<std::size_t>(taken), static_cast<std::size_t>(read));
}

bool fits(const char* pattern, const char* name) {
    if (*pattern == '\0')
        return *name == '\0';
    if (*pattern == '*')
        return fits(pattern + 1, name) || (*name != '\0' && fits(pattern, name + 1));
    if (*pattern == '[')
        if (const auto both = range(pattern, name))
            return fits(pattern + both->first, name + both->second);
    return *name != '\0' && (*pattern == '?' || *pattern == *name) && fits(pattern + 1, name + 1);
}

}  // namespace

Aspects compareScenes(const THREE::Scene& expected, const THREE::Scene& found) {
    const Contents a = contentsOf(expected), b = contentsOf(found);
    Aspects aspects;
    compareMeshes(aspects, a, b);
    compareSuns(aspects, a, b);
    compareBulbs(aspects, a, b);
    compareAmbient(aspects, a.ambient, b.ambient);
    compareCounts(aspects, "mesh", a.bodies.size(), b.bodies.size());
    compareCounts(aspects, "directional", a.suns.size(), shining(b.suns));
    compareCounts(aspects, "point", a.bulbs.size(), shining(b.bulbs));
    aspects["background"] = {same(a.background, b.background), text(b.background)};
    return aspects;
}

bool matches(const std::string& pattern, const std::string& aspect) {
    return fits(pattern.c_str(), aspect.c_str());
}

bool isMeant(const std::vector<std::string>& patterns, const std::string& aspect) {
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
        return pattern != "*" && matches(pattern, aspect);
    });
}

}  // namespace grader
