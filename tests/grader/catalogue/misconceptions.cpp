// The table of misconceptions put together, and the frames of wrong programs.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/misconceptions.hpp"

#include "grader/catalogue/misconception_rows.hpp"
#include "lighting/reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>
#include <stdexcept>

namespace grader {

namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;
using Reference = lighting::reference::Reference<double>;
using Surface = lighting::reference::Surface<double>;

dmat4 matrixOf(const THREE::Object3D& object) {
    const auto place = lighting::reference::placeOf<double>(object);
    return {dvec4(place.x, 0), dvec4(place.y, 0), dvec4(place.z, 0), dvec4(place.origin, 1)};
}

dvec3 vectorOf(const THREE::Color& c) { return {c.r, c.g, c.b}; }

// When a lamp's turn comes in the lab's shaders, which is where a student's loop runs: directional lights, then point lights
// by their exponent. What a loop leaves behind (D8, G4) depends on it.
int turn(const Lamp& lamp) {
    if (!lamp.point)
        return 0;
    return lamp.decay == 0 ? 1 : lamp.decay == 1 ? 2 : lamp.decay == 2 ? 3 : 4;
}

// What all points of a frame have in common.
WrongInput commonInput(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera) {
    WrongInput common{};
    const dmat4 world = matrixOf(camera);
    common.eye = dvec3(world[3]);
    common.view = glm::inverse(world);
    common.clip = camera.projectionMatrix().elements * common.view;
    scene.traverseVisible([&](const THREE::Object3D& object) {
        const auto* light = dynamic_cast<const THREE::Light*>(&object);
        if (light == nullptr)
            return;
        const dvec3 position(matrixOf(object)[3]), color = vectorOf(light->color);
        if (const auto* sun = dynamic_cast<const THREE::DirectionalLight*>(light))
            common.lamps.push_back(
                {false, position, position - dvec3(matrixOf(sun->target)[3]), color, light->intensity, 0, 0});
        else if (const auto* bulb = dynamic_cast<const THREE::PointLight*>(light))
            common.lamps.push_back(
                {true, position, dvec3(0), color, light->intensity, bulb->decay, bulb->distance});
        else
            common.ambient += color * light->intensity;
    });
    std::stable_sort(common.lamps.begin(), common.lamps.end(),
                     [](const Lamp& a, const Lamp& b) { return turn(a) < turn(b); });
    return common;
}

// One point of a lit surface.
WrongInput inputAt(WrongInput p, const Reference& reference, const Surface& s) {
    const auto& body = reference.bodies()[s.body];
    const THREE::BufferGeometry& geometry = *body.mesh->geometry;
    p.n = s.n;
    p.Q = s.Q + reference.eye();
    p.D = body.D;
    p.emitted = body.emitted;
    p.specular = body.gloss.specular;
    p.shininess = body.gloss.shininess;
    p.facing = body.turnsNormals && !s.front ? -1 : 1;
    p.weights = s.weights;
    p.model = matrixOf(*body.mesh);
    std::uint32_t vertices[3];
    geometry.triangle(s.triangle, vertices);
    for (std::size_t i = 0; i < 3; ++i)
        p.corners[i] = geometry.getAttribute("position")->getXYZ(vertices[i]);
    const dvec3 across = glm::cross(p.corners[1] - p.corners[0], p.corners[2] - p.corners[0]);
    for (std::size_t i = 0; i < 3; ++i)
        p.normals[i] =
            rows::unit(body.flat ? across : dvec3(geometry.getAttribute("normal")->getXYZ(vertices[i])));
    return p;
}

void put(std::vector<float>& frame, std::size_t pixel, const dvec3& P) {
    for (std::size_t i = 0; i < 3; ++i)
        frame[pixel * 3 + i] = static_cast<float>(P[static_cast<int>(i)]);
}

bool nothingShines(const WrongInput& p) { return !p.shines(); }

bool matteAndEveryDecayIsTwo(const WrongInput& p) {
    return nothingShines(p) && std::all_of(p.lamps.begin(), p.lamps.end(),
                                           [](const Lamp& lamp) { return !lamp.point || lamp.decay == 2; });
}

bool meshAtTheOrigin(const WrongInput& p) { return p.centre() == dvec3(0); }

bool nothingScaled(const WrongInput& p) {
    const glm::dmat3 m(p.model), product = glm::transpose(m) * m;
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            worst = std::max(worst, std::abs(product[i][j] - (i == j ? 1 : 0)));
    return worst < 1e-12;
}

}  // namespace

const std::vector<Misconception>& misconceptions() {
    static const std::vector<Misconception> all = [] {
        std::vector<Misconception> rows = rows::lightRows();
        for (const auto& more :
             {rows::normalRows(), rows::colorRows(), rows::highlightRows(), rows::rightRows()})
            rows.insert(rows.end(), more.begin(), more.end());
        return rows;
    }();
    return all;
}

const Misconception& misconception(const std::string& id) {
    for (const Misconception& row : misconceptions())
        if (row.id == id)
            return row;
    throw std::out_of_range("no misconception is called '" + id + "'; misconceptions() has all of them");
}

const std::vector<MisconceptionClass>& misconceptionClasses() {
    static const std::vector<MisconceptionClass> all{
        {{"B3", "B5"}, "nothing shines", nothingShines},
        {{"D2", "D3"}, "always", [](const WrongInput&) { return true; }},
        {{"B7", "D1"}, "every k is 2 and nothing shines", matteAndEveryDecayIsTwo},
        {{"B1", "B1C"}, "the mesh is at the origin", meshAtTheOrigin},
        {{"C8", "C9"}, "nothing is scaled", nothingScaled},
    };
    return all;
}

WrongFrames::WrongFrames(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera, int width,
                         int height, std::size_t every) {
    lighting::Switches switches;
    switches.specular = THREE::SpecularModel::phong;
    const Reference reference(scene, camera, switches, width, height);
    std::vector<std::optional<Surface>> seen(static_cast<std::size_t>(width) *
                                             static_cast<std::size_t>(height));
    reference.surfaces([&](int x, int y, const std::optional<Surface>& surface) {
        seen[static_cast<std::size_t>(y * width + x)] = surface;
    });
    const WrongInput common = commonInput(scene, camera);
    const dvec3 background = scene.background ? vectorOf(*scene.background) : dvec3(0);
    truth_.resize(seen.size() * 3);
    std::size_t lit = 0;
    for (std::size_t pixel = 0; pixel < seen.size(); ++pixel) {
        const std::optional<Surface>& surface = seen[pixel];
        put(truth_, pixel, surface ? reference.shade(*surface) : background);
        if (!surface || !reference.bodies()[surface->body].lit || lit++ % every != 0)
            continue;
        points_.push_back(inputAt(common, reference, *surface));
        pixels_.push_back(pixel);
    }
    counted_ = reference.edges();
    for (std::uint8_t& edge : counted_)
        edge = edge == 0 ? 1 : 0;
}

std::vector<float> WrongFrames::frame(const Misconception& equation) const {
    std::vector<float> frame = truth_;
    for (std::size_t i = 0; i < points_.size(); ++i)
        put(frame, pixels_[i], equation.evaluate(points_[i]));
    return frame;
}

bool WrongFrames::sameClass(const Misconception& a, const Misconception& b) const {
    const auto together = [&](const MisconceptionClass& c) {
        return std::find(c.ids.begin(), c.ids.end(), a.id) != c.ids.end() &&
               std::find(c.ids.begin(), c.ids.end(), b.id) != c.ids.end() &&
               std::all_of(points_.begin(), points_.end(), c.holds);
    };
    const auto& classes = misconceptionClasses();
    return std::any_of(classes.begin(), classes.end(), together);
}

Apart apart(const std::vector<float>& a, const std::vector<float>& b,
            const std::vector<std::uint8_t>& counted) {
    Apart result;
    double pixels = 0, far = 0;
    for (std::size_t pixel = 0; pixel < counted.size(); ++pixel) {
        if (counted[pixel] == 0)
            continue;
        double worst = 0;
        for (std::size_t i = pixel * 3; i < pixel * 3 + 3; ++i) {
            const double difference = std::abs(std::clamp(static_cast<double>(a[i]), 0.0, 1.0) -
                                               std::clamp(static_cast<double>(b[i]), 0.0, 1.0));
            worst = std::max(worst, std::isnan(difference) ? 1.0 : difference);
        }
        ++pixels;
        far += worst > 2.0 / 255 ? 1 : 0;
        result.codes = std::max(result.codes, worst * 255);
    }
    result.share = pixels > 0 ? far / pixels : 0;
    return result;
}

}  // namespace grader
