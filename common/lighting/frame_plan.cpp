// Decides what a frame draws, with which lights, and what it can do without.
// SPDX-License-Identifier: MIT
#include "lighting/frame_plan.hpp"

#include "lighting/float_range.hpp"
#include "lighting/frame_space.hpp"
#include "lighting/light_sets.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace lighting {

namespace {

glm::dvec3 toVec(const THREE::Color& c) { return {c.r, c.g, c.b}; }

// Whether a view is P, shown in another way.
bool presents(ViewMode view) {
    return view == ViewMode::red || view == ViewMode::green || view == ViewMode::blue ||
           view == ViewMode::overexposed;
}

bool isZero(const glm::dvec3& v) { return v == glm::dvec3(0); }

class Planner {
  public:
    Planner(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera, const Settings& settings)
        : settings_(settings), data_(isData(settings.view)) {
        plan_.view = settings.view;
        plan_.background = backgroundFor(settings.view, {0, 0, 0});
        plan_.anchor = snapToGrid(settings.focus, settings.focusDistance);
        plan_.unit = frameUnit(scene, settings, plan_.anchor);
        // The camera itself keeps its size, so that view space is world units turned into frame units, and near and far are.
        glm::dmat4 place = camera.matrixWorld.elements;
        place[3] = glm::dvec4((glm::dvec3(place[3]) - plan_.anchor) / plan_.unit, 1);
        view_ = glm::inverse(place);
        projection_ = camera.projectionMatrix();
        projection_[3][2] /= plan_.unit;
        near_ = camera.near / plan_.unit;
        toLighting_ = lightingSpace(settings.space, place);
        plan_.eye = toLighting_ * place[3];
        plan_.lightingToView = view_ * glm::inverse(toLighting_);
        plan_.projection = projection_;
        plan_.near = near_;
    }

    FramePlan run(const THREE::Scene& scene) {
        if (scene.background)
            plan_.background = backgroundFor(settings_.view, toVec(*scene.background));
        scene.traverseVisible([this](const THREE::Object3D& object) {
            if (const auto* light = dynamic_cast<const THREE::Light*>(&object))
                addLight(*light);
        });
        const FloatRange range(plan_);
        scene.traverseVisible([this, &range](const THREE::Object3D& object) {
            if (const auto* mesh = dynamic_cast<const THREE::Mesh*>(&object))
                addMesh(*mesh, range);
        });
        distributeLights(plan_, settings_, hasAmbient_);
        if (settings_.skip)
            std::stable_sort(plan_.draws.begin(), plan_.draws.end(),
                             [](const Draw& a, const Draw& b) { return a.nearestDepth < b.nearestDepth; });
        return std::move(plan_);
    }

  private:
    void skipLight(const THREE::Light& light, const Text& why) {
        plan_.skipped.push_back({&light, why});
        ++plan_.lightsSkipped;
    }

    void skipMesh(const THREE::Mesh& mesh, const Text& why) {
        plan_.skipped.push_back({&mesh, why});
        ++plan_.meshesSkipped;
    }

    // Why a light adds exactly nothing to any pixel; nulls if it may add something.
    Text whyDark(const THREE::Light& light, Term term) const {
        if (light.intensity == 0)
            return Text{"la sua intensità è 0", "its intensity is 0"};
        // A black light still shines when light_color is off: white of the same intensity.
        if (isZero(toVec(light.radiance())) &&
            (term == Term::ambient || settings_.terms.has(Term::lightColor)))
            return Text{"il suo colore è nero", "its colour is black"};
        return settings_.terms.has(term) ? Text{} : Text{"il suo termine è spento", "its term is off"};
    }

    void addLight(const THREE::Light& light) {
        if ((settings_.only != nullptr || data_) && settings_.only != &light)
            return;
        glm::dvec3 color = toVec(light.radiance());
        const Term term = dynamic_cast<const THREE::AmbientLight*>(&light) != nullptr ? Term::ambient
                          : dynamic_cast<const THREE::PointLight*>(&light) != nullptr ? Term::point
                                                                                      : Term::directional;
        plan_.lightColorMatters |=
            term != Term::ambient && light.intensity != 0 && color != glm::dvec3(light.intensity);
        if (term == Term::ambient && settings_.view == ViewMode::exaggerated)
            color *= exaggeration;
        const Text dark = data_ ? Text{} : whyDark(light, term);
        if (settings_.skip && dark.en != nullptr)
            return skipLight(light, dark);
        ++plan_.lightsUsed;
        if (term == Term::ambient) {
            plan_.ambient += dark.en == nullptr ? color : glm::dvec3(0);
            hasAmbient_ = true;
        } else {
            addAddend(light, color, dark.en != nullptr);
        }
    }

    // Object space to frame space.
    glm::dmat4 toFrame(const glm::dmat4& world) const {
        glm::dmat4 m = world;
        m[3] -= glm::dvec4(plan_.anchor, 0);
        for (int column = 0; column < 4; ++column)
            m[column] = glm::dvec4(glm::dvec3(m[column]) / plan_.unit, m[column].w);
        return m;
    }

    void addAddend(const THREE::Light& light, const glm::dvec3& color, bool dark) {
        if (const auto* point = dynamic_cast<const THREE::PointLight*>(&light)) {
            const glm::dvec3 position = glm::dvec3(point->matrixWorld.position()) - plan_.anchor;
            PointAddend addend{position, color, light.intensity, point->decay, point->distance,
                               0,        dark,  &light};
            const bool attenuated = settings_.terms.has(Term::attenuation);
            fitToFloats(addend, plan_.unit, attenuated && !data_);
            if (data_ && attenuated && plan_.unit != 1)
                addend.exponent = -addend.decay * std::log2(plan_.unit);  // f and L by themselves
            if (attenuated && addend.distance > 0 && !data_)
                addend.reach = addend.distance;
            addend.position = toLighting_ * glm::dvec4(addend.position, 1);
            plan_.point.push_back(addend);
        } else if (const auto* directional = dynamic_cast<const THREE::DirectionalLight*>(&light)) {
            const glm::dvec3 w = directional->directionTowardsLight();
            plan_.directional.push_back({glm::dmat3(toLighting_) * w, color, light.intensity, dark, &light});
        }
    }

    void addMesh(const THREE::Mesh& mesh, const FloatRange& range) {
        const THREE::BufferGeometry& geometry = *mesh.geometry;
        const THREE::Material& material = *mesh.material;
        if (!material.visible)
            return skipMesh(mesh, {"il suo materiale non è visibile", "its material is not visible"});
        if (geometry.triangleCount() == 0)
            return skipMesh(mesh, {"non ha triangoli", "it has no triangles"});
        Draw draw;
        draw.mesh = &mesh;
        const THREE::Sphere& sphere = geometry.boundingSphere();
        // Vertices far from their own origin (a map's coordinates) keep their digits: the near origin is zero.
        draw.origin = snapToGrid(sphere.center, std::max(sphere.radius, 1e-30) * 16);
        draw.model = toFrame(mesh.matrixWorld.elements) * glm::translate(glm::dmat4(1.0), draw.origin);
        draw.normalMatrix = settings_.normals == NormalTransform::inverseTranspose
                                ? THREE::normalMatrix(mesh.matrixWorld.elements)
                                : withoutInverseTranspose(mesh.matrixWorld.elements);
        draw.clip = projection_ * view_ * draw.model;
        draw.mirrored = mirrors(glm::dmat3(mesh.matrixWorld.elements));
        if (isZero(glm::dvec3(draw.model[0])) && isZero(glm::dvec3(draw.model[1])) &&
            isZero(glm::dvec3(draw.model[2])))
            return skipMesh(mesh, {"la sua scala è 0", "its scale is 0"});
        draw.outside = !place(draw, sphere);
        if (draw.outside && settings_.skip)
            return skipMesh(mesh, {"è fuori dalla vista della camera", "it is outside the camera's view"});
        if (settings_.space == Space::view) {
            draw.model = toLighting_ * draw.model;
            draw.normalMatrix = glm::dmat3(toLighting_) * draw.normalMatrix;
        }
        const bool lit = material.isLit(), black = lit && settings_.view == ViewMode::specular;
        draw.albedo = black ? glm::dvec3(0) : toVec(material.color);
        draw.emitted = lit && isAddend(settings_.view) ? glm::dvec3(0) : toVec(material.emitted());
        draw.flat = material.flatShading || settings_.shading == Shading::flat ||
                    geometry.getAttribute("normal") == nullptr;
        draw.variant.countNonfinite = settings_.countNonfinite;
        if (presents(settings_.view))
            draw.variant.view = settings_.view;
        if (data_)
            showData(draw, range);
        else if (lit)
            light(draw, range);
        showSides(draw);
        plan_.draws.push_back(draw);
    }

    // What a lit material adds to a draw; its lights come later (distributeLights).
    void light(Draw& draw, const FloatRange& range) {
        const THREE::Material& material = *draw.mesh->material;
        draw.variant.lit = true;
        draw.variant.perVertex = settings_.shading == Shading::vertex;
        draw.variant.terms = settings_.terms.bits();
        draw.variant.emissive = !isZero(draw.emitted);
        draw.variant.doubleSided = material.side != THREE::FrontSide;
        if (const auto* phong = dynamic_cast<const THREE::MeshPhongMaterial*>(&material)) {
            const bool blinn =
                settings_.specular.value_or(phong->specularModel) == THREE::SpecularModel::blinn;
            draw.variant.blinn = blinn;
            draw.specular = toVec(phong->specular);
            draw.shininess = blinn ? std::max(phong->shininess, 1e-4) : phong->shininess;  // as three.js does
        }
        // Blinn's Fresnel factor lets even a black K_S shine at grazing angles.
        const bool shiny = draw.variant.blinn || !isZero(draw.specular);
        if (settings_.skip && !shiny)
            draw.variant.drop(Term::specular);
        // Beyond 2^40 near positions interpolate badly; the direction to the eye needs squares that fit as well.
        const bool extremeView = shiny && (near_ < 0x1p-50 || draw.reach > 0x1p60);
        draw.variant.scaled = draw.reach > 0x1p40 * near_ || extremeView || range.leftBy(draw);
        plan_.litMeshes = true;
        plan_.shiny |= shiny;
        plan_.emissive |= draw.variant.emissive;
        plan_.albedoNotWhite |= draw.albedo != glm::dvec3(1);
    }

    // What a data view makes of a draw; its light comes later (distributeLights).
    void showData(Draw& draw, const FloatRange& range) {
        draw.emitted = glm::dvec3(0);
        const bool lit = draw.mesh->material->isLit();
        plan_.litMeshes |= lit;
        if (!lit || (info(settings_.view).needsLight && plan_.directional.empty() && plan_.point.empty())) {
            draw.albedo = noValue;
            return;
        }
        draw.variant.lit = true;
        draw.variant.view = settings_.view;
        draw.variant.terms =
            settings_.terms.without(Term::directional).without(Term::point).bits();  // these make no factor
        draw.variant.doubleSided = draw.mesh->material->side != THREE::FrontSide;
        draw.variant.scaled = draw.reach > 0x1p40 * near_ || range.leftBy(draw);
        plan_.albedoNotWhite |= draw.albedo != glm::dvec3(1);
    }

    // Which faces are drawn. Those on the back of a closed mesh are hidden by those on its front for an eye outside.
    void showSides(Draw& draw) {
        draw.side = draw.mesh->material->side;
        if (draw.side != THREE::DoubleSide || !settings_.skip || !(draw.nearestDepth > near_) ||
            !draw.mesh->geometry->hidesItsBacks())
            return;
        // Where it is so thin that depths hardly tell front from back, either may be what is seen.
        const double depthStep = 0x1p-24 * draw.farthestDepth * draw.farthestDepth / near_;
        if (!(thickness(draw) > 16 * depthStep))
            return;
        draw.side = THREE::FrontSide;
        draw.variant.doubleSided = false;
        ++plan_.sidesSkipped;
        plan_.skipped.push_back({draw.mesh,
                                 {"le sue facce posteriori sono nascoste: è chiusa, vista da fuori",
                                  "its back faces are hidden: it is closed, and seen from outside"}});
    }

    // Depth of the bounding sphere; false if it is wholly outside one of the planes of the view.
    bool place(Draw& draw, const THREE::Sphere& sphere) const {
        const glm::dvec3 center = sphere.center;
        const glm::dmat4 toView = view_ * draw.model;
        const glm::dvec3 inView = glm::dvec3(toView * glm::dvec4(center - draw.origin, 1));
        double stretch = 0;  // no direction is stretched more than the Frobenius norm of the 3x3
        for (int column = 0; column < 3; ++column)
            stretch += glm::dot(glm::dvec3(toView[column]), glm::dvec3(toView[column]));
        const double radius = sphere.radius * std::sqrt(stretch) * (1 + 1e-9);
        draw.nearestDepth = -inView.z - radius;
        draw.farthestDepth = -inView.z + radius;
        draw.reach = glm::length(inView) + radius;
        const glm::dmat4 rows = glm::transpose(projection_);
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                const glm::dvec4 plane = rows[3] + sign * rows[axis];
                // Floats round both sides of the inequality that the driver clips by: at the far plane that is a long way.
                const glm::dvec4 sizes = glm::abs(rows[3]) + glm::abs(rows[axis]);
                const double rounding = 0x1p-20 * glm::dot(sizes, glm::dvec4(glm::abs(inView) + radius, 1));
                if (glm::dot(plane, glm::dvec4(inView, 1)) <
                    -radius * glm::length(glm::dvec3(plane)) - rounding)
                    return false;
            }
        return true;
    }

    const Settings& settings_;
    const bool data_;  // a factor is shown, not P
    FramePlan plan_;
    glm::dmat4 view_;
    glm::dmat4 projection_;
    glm::dmat4 toLighting_;  // from frame space
    double near_;  // frame units
    bool hasAmbient_ = false;
};

}  // namespace

FramePlan planFrame(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                    const Settings& settings) {
    const Settings wanted = settingsFor(scene, settings);
    return Planner(scene, camera, wanted).run(scene);
}

}  // namespace lighting
