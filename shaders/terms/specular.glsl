// TERM specular | slide 45 | K_S max(0, R . v)^s where n . w > 0: the highlight (45 draws R, the formula is the next lecture's) | off: 0
// SPDX-License-Identifier: MIT
#if TERM_SPECULAR

uniform vec3 eyePosition;    // the camera, in the space of Q
uniform vec3 specularColor;  // K_S
uniform float shininess;     // s

// v: unit vector from the point towards the eye; 0 at the eye itself, where a vertex may be but no fragment
vec3 view_direction(vec3 Q)
{
    vec3 v = eyePosition - Q;
    watch(v);
    shrink(v);
    float length2 = dot(v, v);
    return length2 > 0.0 ? v / sqrt(length2) : vec3(0.0);
}

// max(0, a . b)^s of unit vectors. Where a and b are almost the same, |a - b|^2 / 2 knows 1 - a . b to more digits than the
// dot product does, and a large s asks for them.
float cosine_power(vec3 a, vec3 b, float s)
{
    vec3 apart = a - b;
    float x = 0.5 * dot(apart, apart);  // 1 - a . b
    float y = min(x, 0.125);
    float t = y / (2.0 - y);            // ln(1 - y) = -2 artanh(t), of which three terms are enough
    float small = exp(-2.0 * s * t * (1.0 + t * t * (1.0 / 3.0 + 0.2 * t * t)));
    return x < 0.125 ? small : x < 1.0 ? pow(1.0 - x, s) : 0.0;
}

// three.js's highlight: Blinn's half vector h, Schlick's Fresnel factor, and a factor that keeps the energy of the lobe
vec3 blinn(vec3 n, vec3 w, vec3 v)
{
    vec3 sum = w + v;
    float length2 = dot(sum, sum);
    vec3 h = length2 > 0.0 ? sum / sqrt(length2) : vec3(0.0);
    float vh = clamp(dot(v, h), 0.0, 1.0);
    float grazing = exp2((-5.55473 * vh - 6.98316) * vh);
    float lobe = length2 > 0.0 ? cosine_power(n, h, shininess) : 0.0;
    return (lobe * dot(n, w) * (0.25 * (0.5 * shininess + 1.0))) * (specularColor * (1.0 - grazing) + vec3(grazing));
}

// n, w, v: unit vectors, all away from the point
vec3 highlight(vec3 n, vec3 w, vec3 v)
{
    float c = dot(n, w);
    vec3 R = 2.0 * c * n - w;  // w mirrored about n
    return c > 0.0 ? (BLINN ? blinn(n, w, v) : cosine_power(R, v, shininess) * specularColor) : vec3(0.0);
}

// What a light's share of diffuse reflection becomes with its highlight; f: how much of the light arrives
vec3 add_highlight(vec3 diffuse, vec3 n, vec3 w, vec3 v, float f) { return add(diffuse, f * highlight(n, w, v)); }

#else

vec3 view_direction(vec3 Q) { return vec3(0.0); }
vec3 add_highlight(vec3 diffuse, vec3 n, vec3 w, vec3 v, float f) { return diffuse; }

#endif
