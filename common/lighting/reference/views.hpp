// What the reference shows besides the lit scene: lighting/views.hpp says what each view is, this computes it from the reference's own
// equation, without the shaders.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/equation.hpp"
#include "lighting/views.hpp"
#include "three/scene.hpp"

#include <array>
#include <optional>

namespace lighting::reference {

/// How the scene is looked at: ViewMode, and the light that is there alone (null: all are).
struct Look {
    ViewMode view = ViewMode::final;
    const THREE::Light* only = nullptr;
};

/// A look with the light that its factors are of, if there is none yet: the first of the scene that has a direction.
inline Look lookAt(const THREE::Scene& scene, Look look) {
    if (!isData(look.view))
        return look;
    const THREE::Light* first = nullptr;
    scene.traverseVisible([&](const THREE::Object3D& object) {
        const bool wanted = dynamic_cast<const THREE::DirectionalLight*>(&object) != nullptr ||
                            dynamic_cast<const THREE::PointLight*>(&object) != nullptr;
        if (wanted && first == nullptr)
            first = static_cast<const THREE::Light*>(&object);
    });
    if (look.only == nullptr)
        look.only = first;
    return look;
}

/// The terms that are on in a view. Factors have their value even where the addend that they are part of is off.
inline TermSet termsIn(ViewMode view, TermSet terms) {
    if (isData(view))
        return terms.with(Term::directional).with(Term::point).without(Term::specular);
    if (view == ViewMode::directional || view == ViewMode::ambient)
        terms = terms.without(Term::point);
    if (view == ViewMode::point || view == ViewMode::ambient)
        terms = terms.without(Term::directional);
    if (view == ViewMode::specular)
        terms = terms.with(Term::albedo);  // which is black
    return isAddend(view) && view != ViewMode::ambient ? terms.without(Term::ambient) : terms;
}

/// The colours of the views, in the scalar T.
template <class T>
class Painter {
  public:
    explicit Painter(ViewMode view) : view_(view) {}

    /// What a pixel shows of P. `fromLeft` and `fromBottom`: its place, from 0.
    Vec3<T> present(const Vec3<T>& P, int fromLeft, int fromBottom) const {
        switch (view_) {
        case ViewMode::red:
            return Vec3<T>(P.x);
        case ViewMode::green:
            return Vec3<T>(P.y);
        case ViewMode::blue:
            return Vec3<T>(P.z);
        case ViewMode::overexposed:
            break;
        default:
            return P;
        }
        int over = 0;
        for (int channel = 0; channel < 3; ++channel)
            over += P[channel] * T(255) > T(255.5) ? 1 : 0;
        static constexpr std::array<int, 3> colors{0x56B4E9, 0xF0E442, 0xFFFFFF};
        if ((fromLeft + fromBottom) % 8 < 2 * over)
            return code(colors[static_cast<std::size_t>(over - 1)]);
        return T(0.35) * Vec3<T>(limit(P.x), limit(P.y), limit(P.z));
    }

    /// What a data view shows of a lit point. The equation has the one light of the view, or none.
    Vec3<T> factor(const Equation<T>& equation, const Lit<T>& at, int fromLeft, int fromBottom) const {
        if (view_ == ViewMode::albedo)
            return equation.albedo(at.D);
        if (view_ == ViewMode::normals)
            return (at.n + T(1)) / T(2);
        std::optional<Addend<T>> light;
        equation.lighting(at, [&light](const Addend<T>& addend) { light = addend; });
        if (!light)
            return toColor(noValue);
        switch (view_) {
        case ViewMode::lightColor:
            return light->L;
        case ViewMode::w:
            return (light->w + T(1)) / T(2);
        case ViewMode::attenuation:
            return octaves(light->f);
        case ViewMode::bands:
            return bands(light->cosine, (fromLeft + fromBottom) % 6 < 2);
        case ViewMode::clamp:
            return greys(light->clamped);
        default:
            return greys(light->cosine);
        }
    }

    /// An unlit surface in a data view, and what is behind everything.
    Vec3<T> unlit(const Vec3<T>& color) const { return isData(view_) ? toColor(noValue) : color; }
    Vec3<T> background(const Vec3<T>& color) const {
        if (isData(view_))
            return toColor(noSurface);
        return view_ == ViewMode::overexposed
                   ? T(0.35) * Vec3<T>(limit(color.x), limit(color.y), limit(color.z))
                   : present(color, 0, 0);
    }

  private:
    static T limit(const T& x) { return x < T(0) ? T(0) : x > T(1) ? T(1) : x; }
    static Vec3<T> toColor(const glm::dvec3& v) { return {T(v.x), T(v.y), T(v.z)}; }
    static Vec3<T> code(int rgb) { return Vec3<T>(T(rgb >> 16), T(rgb >> 8 & 0xFF), T(rgb & 0xFF)) / T(255); }

    static Vec3<T> greys(const T& x) { return x < T(0) ? code(0x56B4E9) * limit(-x) : Vec3<T>(x); }

    static Vec3<T> bands(const T& x, bool hatch) {
        const int band = std::clamp(static_cast<int>(std::floor(static_cast<double>(x * T(10)))), -10, 9);
        if (band >= 0)
            return Vec3<T>(T(band + 1) / T(10));
        if (hatch)
            return Vec3<T>(T(0));
        const T share = T(-band) / T(10);
        return code(0x264066) * (T(1) - share) + code(0x59B2FF) * share;
    }

    // A colour per octave from 1/64 to 4, and between two what lies between.
    static Vec3<T> octaves(const T& f) {
        static constexpr std::array<int, 9> colors{0x2E0856, 0x352678, 0x304887, 0x28698C, 0x218A87,
                                                   0x38A973, 0x74C452, 0xC0D739, 0xFEEA5A};
        if (!(f > T(1) / T(64)))
            return code(colors.front());
        if (!(f < T(4)))
            return code(colors.back());
        const double place = std::log2(static_cast<double>(f)) + 6;
        const auto below = static_cast<std::size_t>(std::min(place, 7.0));
        const T share = T(place - static_cast<double>(below));
        return code(colors[below]) * (T(1) - share) + code(colors[below + 1]) * share;
    }

    ViewMode view_;
};

}  // namespace lighting::reference
