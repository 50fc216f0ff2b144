// The hidden scenes: everything is placed as the camera sees it, so that no seed hides what matters.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/hidden_scene.hpp"

#include "three/three.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <random>

namespace grader {

namespace {

using THREE::Vector3;

constexpr double sphereRadius = 0.9;

// Numbers from a seed. The engine's are the same everywhere; the library's distributions are not. Nor is the order in which
// the arguments of a function are computed: only one of them may throw the dice, or they stand in braces.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    /// In [low, high] or in [-high, -low].
    double either(double low, double high) {
        const double x = between(2 * low - high, high);
        return x < low ? x - 2 * low : x;
    }
    Vector3 eithers(double low, double high) {
        return Vector3{either(low, high), either(low, high), either(low, high)};
    }
    /// Its three channels differ by at least a quarter of `brightness`.
    THREE::Color color(double brightness) {
        double c[] = {between(0.85, 1), between(0.5, 0.6), between(0.15, 0.25)};
        std::swap(c[0], c[engine_() % 3]);
        std::swap(c[1], c[1 + engine_() % 2]);
        return THREE::Color(c[0], c[1], c[2]).multiplyScalar(brightness);
    }
    /// As a lamp's filter: no channel is dark.
    THREE::Color tint() { return color(0.7).add(THREE::Color(0.3, 0.3, 0.3)); }

  private:
    std::mt19937_64 engine_;
};

// The camera's own axes in world space.
struct View {
    Vector3 right, up, back, centre;

    /// A point of world space from what one sees: to the right, upwards, towards the camera.
    Vector3 at(double x, double y, double z) const { return Vector3(along(x, y, z)).add(centre); }
    Vector3 along(double x, double y, double z) const {
        return Vector3(right)
            .multiplyScalar(x)
            .add(Vector3(up).multiplyScalar(y))
            .add(Vector3(back).multiplyScalar(z));
    }
};

View addCamera(THREE::LoadedScene& hidden, Dice& dice) {
    View view;
    view.centre = dice.eithers(1.5, 4);
    const double azimuth = dice.either(0.5, 2.4);
    const double height = dice.either(0.3, 0.8);
    const Vector3 direction(std::sin(azimuth) * std::cos(height), std::sin(height),
                            std::cos(azimuth) * std::cos(height));
    auto camera = std::make_unique<THREE::PerspectiveCamera>(40, 1, 0.5, 50);
    camera->position = Vector3(direction).multiplyScalar(6.3).add(view.centre);
    camera->up = Vector3(dice.either(0.3, 0.6), 1, 0.1);
    camera->lookAt(view.centre);
    camera->updateMatrix();
    const glm::dmat4& axes = camera->matrix;
    view.right = glm::dvec3(axes[0]);
    view.up = glm::dvec3(axes[1]);
    view.back = glm::dvec3(axes[2]);
    hidden.camera = &hidden.scene->add(std::move(camera));
    return view;
}

// All meshes have the same finish, and each its own colours.
std::shared_ptr<THREE::MeshLambertMaterial> makeMaterial(Dice& dice, Finish finish, double shininess) {
    const THREE::Color D = dice.color(0.9), K_S = dice.color(0.8);
    if (finish == Finish::matte)
        return std::make_shared<THREE::MeshLambertMaterial>(D);
    auto material = std::make_shared<THREE::MeshPhongMaterial>(D);
    material->specular = K_S;
    material->shininess = shininess;
    return material;
}

// A mesh that is turned first and scaled unequally then, which needs two objects.
THREE::Group& addMesh(THREE::Scene& scene, Dice& dice, const Vector3& place,
                      std::shared_ptr<THREE::BufferGeometry> geometry,
                      std::shared_ptr<THREE::MeshLambertMaterial> material) {
    auto mesh = std::make_unique<THREE::Mesh>(THREE::Handle<THREE::BufferGeometry>(geometry),
                                              THREE::Handle<THREE::Material>(material));
    const Vector3 turn = dice.eithers(0.4, 0.9), turnAgain = dice.eithers(0, 0.5);
    mesh->rotation.set(turn.x, turn.y, turn.z);
    auto stretched = std::make_unique<THREE::Group>();
    stretched->position = place;
    stretched->scale = Vector3{dice.between(1.3, 1.5), dice.between(0.6, 0.7), dice.between(0.9, 1.1)};
    stretched->rotation.set(turnAgain.x, turnAgain.y, turnAgain.z);
    stretched->add(std::move(mesh));
    return scene.add(std::move(stretched));
}

// A point this far outside a sphere that addMesh has stretched.
Vector3 outside(THREE::Group& stretched, double radius, const Vector3& direction, double distance) {
    stretched.updateMatrix();
    const Vector3 d = Vector3(direction).normalize();
    const double reach =
        radius / Vector3(glm::inverse(glm::dmat3(stretched.matrix.elements)) * glm::dvec3(d)).length();
    return Vector3(d).multiplyScalar(reach + distance).add(stretched.position);
}

// Sets what all lights have and puts it into the scene.
template <class L>
void addLight(THREE::Scene& scene, std::unique_ptr<L> light, const THREE::Color& color, double intensity,
              const Vector3& position) {
    light->color = color;
    light->intensity = intensity;
    light->position = position;
    scene.add(std::move(light));
}

// From behind: it reaches little of what is seen, but a highlight on the unlit side shows at grazing angles.
void addBackLight(THREE::Scene& scene, Dice& dice, const View& view) {
    const THREE::Color color = dice.tint();
    const double strength = dice.between(1.6, 2), x = dice.either(0.2, 0.4), y = dice.either(0.2, 0.4);
    addLight(scene, std::make_unique<THREE::DirectionalLight>(), color, strength, view.along(x, y, -2.5));
}

void addLights(THREE::Scene& scene, Dice& dice, const View& view, THREE::Group& sphere) {
    const THREE::Color colors[] = {dice.tint(), dice.tint(), dice.tint(), dice.color(0.15)};
    const double strengths[] = {dice.between(0.6, 0.8), dice.between(1.3, 1.7), dice.between(1.2, 1.6)};
    const double x[] = {dice.between(2, 3), dice.between(-0.4, 0.4), dice.between(-3, -2)};
    const double y[] = {dice.between(1, 2), dice.between(0.1, 0.5), dice.between(0.2, 1.2)};
    const double z[] = {dice.between(-0.8, 0.2), 1, dice.between(0.3, 1.2)};
    addLight(scene, std::make_unique<THREE::DirectionalLight>(), colors[0], strengths[0],
             view.along(x[0], y[0], z[0]));
    addLight(scene, std::make_unique<THREE::PointLight>(0xFFFFFF, 1, 0, 2), colors[1], strengths[1],
             outside(sphere, sphereRadius, view.along(x[1], y[1], z[1]), 0.45));
    addLight(scene, std::make_unique<THREE::PointLight>(0xFFFFFF, 1, 0, 1), colors[2], strengths[2],
             view.at(x[2], y[2], z[2]));
    scene.add(std::make_unique<THREE::AmbientLight>(THREE::Color(colors[3]).add(0x303030)));
}

}  // namespace

THREE::LoadedScene hiddenScene(std::uint64_t seed, Finish finish) {
    Dice dice(seed);
    THREE::LoadedScene hidden;
    hidden.scene = std::make_unique<THREE::Scene>();
    THREE::Scene& scene = *hidden.scene;
    scene.background = 0x203040;
    const View view = addCamera(hidden, dice);
    const double x[] = {0.3, dice.between(-1.3, -1), dice.between(1, 1.3)};
    const double y[] = {dice.between(0.8, 1), dice.between(-1.3, -0.9), dice.between(-1.4, -1.1)};
    const Vector3 place = view.at(x[1], y[1], dice.between(-0.2, 0.4));
    const auto knotMaterial = makeMaterial(dice, finish, 8), sphereMaterial = makeMaterial(dice, finish, 4),
               boxMaterial = makeMaterial(dice, finish, 6);
    boxMaterial->emissive = 0x000A14;
    addMesh(scene, dice, view.at(x[0], y[0], 0), std::make_shared<THREE::TorusKnotGeometry>(0.8, 0.3, 96, 16),
            knotMaterial);
    THREE::Group& sphere = addMesh(
        scene, dice, place, std::make_shared<THREE::SphereGeometry>(sphereRadius, 7, 5), sphereMaterial);
    addMesh(scene, dice, view.at(x[2], y[2], 0), std::make_shared<THREE::BoxGeometry>(1.2, 1.2, 1.2),
            boxMaterial);
    addLights(scene, dice, view, sphere);
    if (finish == Finish::shiny)
        addBackLight(scene, dice, view);
    return hidden;
}

}  // namespace grader
