// The lighting equation on the CPU, in any scalar: the independent evaluation that frames are judged by. Laid out like
// shaders/lighting.glsl and written without it, so that the two can be read side by side.
//
//     P  =  ( sum_i  max(0, n . w_i)  f(d_i)  D (x) L_i )  +  D (x) L_A        (slide 42)
//
// and for shiny materials a highlight K_S max(0, R . v)^s f(d_i) (x) L_i with each light (slides 44-45).
//
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/terms.hpp"
#include "three/lights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <type_traits>
#include <vector>

namespace lighting::reference {

template <class T>
using Vec3 = glm::vec<3, T>;

/// A directional or a point light. An ambient one is only a colour.
template <class T>
struct Light {
    const THREE::Light* source;  ///< which light of the scene it is; its numbers are all in here
    Vec3<T> place;  ///< directional: unit vector towards it; point: position relative to the eye; world space
    Vec3<T> L;  ///< colour x intensity (slide 26)
    T intensity;  ///< what stays when light_color is off
    T decay;  ///< k of f(d) = 1 / d^k (slide 31)
    T distance;  ///< where three.js's window reaches 0, world units; 0: no window
};

/// The highlight of a material. THREE::MeshPhongMaterial says what the members mean.
template <class T>
struct Gloss {
    Vec3<T> specular{T(0)};  ///< K_S
    T shininess{0};  ///< s
    THREE::SpecularModel model = THREE::SpecularModel::phong;

    /// three.js's model shines at grazing angles even where K_S is black: its Fresnel factor goes to 1.
    bool shines() const {
        return model == THREE::SpecularModel::blinn || specular.x > T(0) || specular.y > T(0) ||
               specular.z > T(0);
    }
};

/// The point that is lit: everything about it that the equation asks for.
template <class T>
struct Lit {
    Vec3<T> n;  ///< unit normal, or zero: none; world space
    Vec3<T> Q;  ///< the point, world space relative to the eye
    Vec3<T> D;  ///< base colour
    Gloss<T> gloss;
};

/// What one light adds to one point, with every factor on the way.
template <class T>
struct Addend {
    const THREE::Light* light;
    Vec3<T> w;  ///< unit vector towards the light, world space; zero if the light is in the very point
    T d;  ///< distance to the light, world units; 0 for a directional light, which has none
    T cosine;  ///< n . w, before the clamp
    T clamped;  ///< max(0, n . w)
    T f;  ///< attenuation
    Vec3<T> L;  ///< the light's colour x intensity
    Vec3<T> specular;  ///< the highlight, K_S max(0, R . v)^s of slide 45 or three.js's
    Vec3<T> value;  ///< f (clamped D + specular) (x) L
};

/// The lights of a scene and the symbols that are on.
template <class T>
class Equation {
  public:
    TermSet terms = TermSet::all();
    std::vector<Light<T>> directionalLights, pointLights;  ///< each in the order of the scene
    Vec3<T> ambientLight{T(0)};  ///< L_A, the sum of all ambient lights
    int ambientLights = 0;  ///< how many it is the sum of

    /// P of a point. `each` is called with the Addend of every light.
    template <class Each>
    Vec3<T> lighting(Lit<T> at, const Each& each) const {
        at.D = albedo(at.D);
        // Two loops over the lights: the one where nothing shines is a fifth faster for not knowing of highlights.
        return terms.has(Term::specular) && at.gloss.shines() ? sum<true>(at, each) : sum<false>(at, each);
    }
    Vec3<T> lighting(const Lit<T>& at) const { return lighting(at, Silent{}); }
    Vec3<T> lighting(const Vec3<T>& n, const Vec3<T>& Q, const Vec3<T>& D) const {
        return lighting(Lit<T>{n, Q, D, {}});
    }

    // The factors. Off, each is 1 (slides in terms.cpp).
    Vec3<T> albedo(const Vec3<T>& D) const { return terms.has(Term::albedo) ? D : Vec3<T>(T(1)); }
    T cosine(const Vec3<T>& n, const Vec3<T>& w) const {
        return terms.has(Term::cosine) ? glm::dot(n, w) : T(1);
    }
    T clamp(T x) const { return terms.has(Term::clamp) && x < T(0) ? T(0) : x; }
    T attenuation(T d, T perDistance, const Light<T>& light) const {
        return terms.has(Term::attenuation) ? power(perDistance, light.decay) * window(d, light.distance)
                                            : T(1);
    }
    Vec3<T> lightColor(const Light<T>& light) const {
        return terms.has(Term::lightColor) ? light.L : Vec3<T>(light.intensity);
    }

    // The addends. Off, each is 0.
    Vec3<T> ambient(const Vec3<T>& D) const {
        return terms.has(Term::ambient) ? D * ambientLight : Vec3<T>(T(0));
    }
    /// The highlight: towards the eye, at the origin, from where light of direction w is mirrored. 0 where n . w <= 0.
    static Vec3<T> highlight(const Lit<T>& at, const Vec3<T>& w) {
        using std::pow;
        const T c = glm::dot(at.n, w);
        if (!(c > T(0)))
            return Vec3<T>(T(0));
        const Vec3<T> v = direction(-at.Q);
        if (at.gloss.model == THREE::SpecularModel::blinn)
            return blinn(at, w, v, c);
        const T mirrored = glm::dot(T(2) * c * at.n - w, v);  // R . v
        return mirrored > T(0) ? at.gloss.specular * T(pow(mirrored, at.gloss.shininess)) : Vec3<T>(T(0));
    }

  private:
    struct Silent {
        void operator()(const Addend<T>&) const {}
    };

    template <bool shines, class Each>
    Vec3<T> sum(const Lit<T>& at, const Each& each) const {
        // Without a listener, what is behind the surface and clamped to 0 is not worth its square root.
        const bool skipsBehind =
            std::is_same_v<Each, Silent> && terms.has(Term::cosine) && terms.has(Term::clamp);
        Vec3<T> P{T(0)};
        const auto add = [&P, &each](const Addend<T>& addend) {
            P += addend.value;
            each(addend);
        };
        if (terms.has(Term::directional))
            for (const Light<T>& light : directionalLights)
                add(product<shines>(light, light.place, T(0), T(1), at));
        if (terms.has(Term::point))
            for (const Light<T>& light : pointLights)
                if (!skipsBehind || glm::dot(at.n, light.place - at.Q) > T(0))
                    add(pointLight<shines>(light, at));
        return P + ambient(at.D);
    }

    template <bool shines>
    Addend<T> pointLight(const Light<T>& light, const Lit<T>& at) const {
        using std::sqrt;
        const Vec3<T> v = light.place - at.Q;
        const T d = sqrt(glm::dot(v, v));
        // A light in the very point has no direction and adds nothing.
        const T perDistance = d > T(0) ? T(1) / d : T(0);
        const T f = d > T(0) ? attenuation(d, perDistance, light) : T(0);
        return product<shines>(light, v * perDistance, d, f, at);
    }

    template <bool shines>
    Addend<T> product(const Light<T>& light, const Vec3<T>& w, T d, T f, const Lit<T>& at) const {
        const T c = cosine(at.n, w);
        const T clamped = clamp(c);
        const Vec3<T> L = lightColor(light);
        Addend<T> addend{light.source, w, d, c, clamped, f, L, Vec3<T>(T(0)), (clamped * f) * (at.D * L)};
        if constexpr (shines) {
            addend.specular = highlight(at, w);
            addend.value += f * (addend.specular * L);
        }
        return addend;
    }

    // v / |v|; zero for the zero vector
    static Vec3<T> direction(const Vec3<T>& v) {
        using std::sqrt;
        const T squared = glm::dot(v, v);
        return squared > T(0) ? v / T(sqrt(squared)) : v;
    }

    // three.js r146, BRDF_BlinnPhong: Schlick's Fresnel factor in the form with exp2, G = 1/4, D = (s/2 + 1) (n . h)^s
    static Vec3<T> blinn(const Lit<T>& at, const Vec3<T>& w, const Vec3<T>& v, T c) {
        using std::exp2;
        using std::pow;
        const Vec3<T> h = direction(w + v);
        const T nh = glm::dot(at.n, h), vh = std::max(T(0), std::min(T(1), glm::dot(v, h)));
        if (!(nh > T(0)))
            return Vec3<T>(T(0));
        const T grazing = exp2((T(-5.55473) * vh - T(6.98316)) * vh);
        const T lobe = T(0.25) * (at.gloss.shininess / T(2) + T(1)) * T(pow(nh, at.gloss.shininess));
        return (at.gloss.specular * (T(1) - grazing) + grazing) * (lobe * c);
    }

    // (1/d)^k, up to a factor that no picture can tell from infinity and that keeps every product finite
    static T power(T perDistance, T k) {
        using std::pow;
        const T factor = k == T(2)   ? perDistance * perDistance
                         : k == T(1) ? perDistance
                         : k == T(0) ? T(1)
                                     : pow(perDistance, k);
        return factor < largestFactor() ? factor : largestFactor();
    }

    // three.js: pow2(saturate(1 - pow4(d / distance)))
    static T window(T d, T distance) {
        if (!(distance > T(0)))
            return T(1);
        if (!(d < distance))
            return T(0);
        const T r = d / distance;
        const T rest = T(1) - (r * r) * (r * r);
        return rest * rest;
    }

    static T largestFactor() {
        return T(std::ldexp(1.0, std::min(400, std::numeric_limits<T>::max_exponent * 2 / 5)));
    }
};

}  // namespace lighting::reference
