// The probe's table and its line.
// SPDX-License-Identifier: MIT
#include "lab/live/probe_text.hpp"

#include "lab/live/numbered_lights.hpp"
#include "lab/live/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace lab {

using lighting::Term;
using lighting::Text;
using lighting::reference::Sight;

namespace {

constexpr int exact = 6;  // significant digits of the line

std::string off(bool isOff, Language language) { return isOff ? say({" (spento)", " (off)"}, language) : ""; }

std::string codes(const std::array<std::uint8_t, 3>& code) {
    return significant(glm::dvec3(code[0], code[1], code[2]), exact);
}

glm::dvec3 differenceOf(const ProbeReport& report) {
    glm::dvec3 difference(0);
    for (int c = 0; c < 3; ++c)
        difference[c] = static_cast<double>((*report.drawn)[static_cast<std::size_t>(c)]) -
                        report.code[static_cast<std::size_t>(c)];
    return difference;
}

glm::dvec3 highlightOf(const ProbeReport& report) {
    glm::dvec3 sum(0);
    for (const ProbeLight& light : report.lights)
        if (light.counted)
            sum += light.highlight;
    return sum;
}

// Of unit vectors: at a right angle it is 0.
double cosineOf(double x) { return std::abs(x) < 1e-12 ? 0 : x; }

bool inThePoint(const ProbeLight& light) { return !light.directional && light.addend.d == 0; }

std::string whereIs(const ProbeReport& report, Language language) {
    if (report.pixel)
        return "(" + std::to_string((*report.pixel)[0]) + ", " + std::to_string((*report.pixel)[1]) + ")";
    return say({"nessuno", "none"}, language);
}

Text sightText(Sight sight) {
    switch (sight) {
    case Sight::hidden:
        return {"nascosto dietro qualcosa", "hidden behind something"};
    case Sight::turnedAway:
        return {"girato: il lato disegnato guarda altrove",
                "turned away: the side that is drawn faces elsewhere"};
    case Sight::outside:
        return {"fuori dall'immagine", "outside the picture"};
    case Sight::visible:
        break;
    }
    return {"visibile", "visible"};
}

// --- the table

// What stands at the left of each row.
Line headline(Language language) {
    Line line;
    for (const Text& title :
         {Text{"luce", "light"}, Text{"ω", "ω"}, Text{"n·ω", "n·ω"}, Text{"max(0, ·)", "max(0, ·)"},
          Text{"f(d)", "f(d)"}, Text{"d", "d"}, Text{"L", "L"}, Text{"diffusa", "diffuse"}})
        line.push_back({say(title, language), Tone::title});
    return line;
}

Line lightColumn(const ProbeReport& report, const ProbeLight& light, Language language) {
    const auto number = [&](double value, Term term) {
        return Span{significant(value, 4) + off(!report.on(term), language),
                    report.on(term) ? Tone::plain : Tone::idle};
    };
    const Tone tone = light.counted ? Tone::plain : Tone::off;
    Line line{{lightTitle(light.number, light.name, language) + off(!light.counted, language), tone}};
    line.push_back({inThePoint(light) ? say({"nel punto stesso", "in the very point"}, language)
                                      : shortText(light.addend.w),
                    Tone::plain});
    line.push_back(number(cosineOf(light.addend.cosine), Term::cosine));
    line.push_back(number(cosineOf(light.addend.clamped), Term::clamp));
    line.push_back(light.directional ? Span{"1", Tone::plain} : number(light.addend.f, Term::attenuation));
    line.push_back({light.directional ? "-" : significant(light.addend.d, 4), Tone::plain});
    line.push_back({colorText(light.addend.L) + off(!report.on(Term::lightColor), language),
                    report.on(Term::lightColor) ? Tone::plain : Tone::idle});
    line.push_back({shortText(light.diffuse), tone});
    return line;
}

void addLights(const ProbeReport& report, Language language, std::size_t most, std::vector<Line>& lines) {
    std::vector<Line> columns{headline(language)};
    std::vector<int> told = brightestLights(report, most);
    // Lights that are off come where room is left.
    for (const ProbeLight& light : report.lights)
        if (!light.counted && told.size() < most)
            told.push_back(light.number);
    for (const ProbeLight& light : report.lights)
        if (std::find(told.begin(), told.end(), light.number) != told.end())
            columns.push_back(lightColumn(report, light, language));
    for (std::size_t row = 0; row < columns[0].size(); ++row) {
        Line line;
        for (const Line& column : columns)
            line.push_back(column[row]);
        lines.push_back(std::move(line));
    }
    if (told.size() < report.lights.size())
        lines.push_back({{"+ " + std::to_string(report.lights.size() - told.size()) +
                              say({" altre luci", " more lights"}, language),
                          Tone::idle}});
}

void addSums(const ProbeReport& report, Language language, std::vector<Line>& lines) {
    const auto row = [&](const Text& name, const glm::dvec3& value, bool isOff) {
        lines.push_back({{say(name, language), Tone::plain},
                         {shortText(value) + off(isOff, language), isOff ? Tone::idle : Tone::plain}});
    };
    if (report.probe.lit) {
        row({"ambiente D ⊗ L_A", "ambient D ⊗ L_A"}, report.probe.ambient, !report.on(Term::ambient));
        if (report.probe.emitted != glm::dvec3(0))
            row({"emessa", "emitted"}, report.probe.emitted, false);
        if (report.shines())
            row({"riflesso lucido", "highlight"}, highlightOf(report), !report.on(Term::specular));
    }
    row({"P", "P"}, report.probe.P, false);
    row({"P tra 0 e 1", "P clamped"}, report.clamped, false);
    lines.push_back(
        {{say({"codice a 8 bit", "8-bit code"}, language), Tone::title}, {codes(report.code), Tone::title}});
    if (!report.drawn)
        return;
    const glm::dvec3 difference = differenceOf(report);
    const double most = std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
    lines.push_back({{"GPU", Tone::plain}, {codes(*report.drawn), Tone::plain}});
    // Beside a pixel's centre the two evaluate different points.
    lines.push_back(
        {{say({"differenza", "difference"}, language), Tone::plain},
         {significant(difference, exact), report.centre && most > 1 ? Tone::wrong : Tone::plain}});
}

// --- the line

class Fields {
  public:
    explicit Fields(Language language) : language_(language) {}
    void add(const std::string& name, const std::string& value) {
        text_ += (text_.empty() ? "probe " : "; ") + name + " = " + value;
    }
    void add(const std::string& name, const glm::dvec3& v, bool on = true) {
        add(name, significant(dusted(v), exact) + off(!on, language_));
    }
    void add(const std::string& name, double value, bool on = true) {
        add(name, significant(value, exact) + off(!on, language_));
    }
    const std::string& text() const { return text_; }

  private:
    Language language_;
    std::string text_;
};

// A name of the scene cannot be taken for the end of a field.
std::string harmless(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ';' || static_cast<unsigned char>(c) < 32; }, ' ');
    return name;
}

void addLight(const ProbeReport& report, const ProbeLight& light, Language language, Fields& fields) {
    const std::string name = "light " + std::to_string(light.number);
    const Text kind = light.directional ? Text{"direzionale", "directional"} : Text{"posizionale", "point"};
    fields.add(name, say(kind, language) + (light.name.empty() ? "" : " '" + harmless(light.name) + "'") +
                         off(!light.counted, language));
    fields.add(name + " w", light.addend.w);
    fields.add(name + " n.w", cosineOf(light.addend.cosine), report.on(Term::cosine));
    fields.add(name + " max", cosineOf(light.addend.clamped), report.on(Term::clamp));
    fields.add(name + " f", light.addend.f, light.directional || report.on(Term::attenuation));
    if (!light.directional)
        fields.add(name + " d", light.addend.d);
    fields.add(name + " L", light.addend.L, report.on(Term::lightColor));
    fields.add(name + " diffuse", light.diffuse, light.counted);
    if (report.shines())
        fields.add(name + " highlight", light.highlight, light.counted && report.on(Term::specular));
}

}  // namespace

std::vector<int> brightestLights(const ProbeReport& report, std::size_t count) {
    std::vector<std::pair<double, int>> strengths;
    for (const ProbeLight& light : report.lights)
        if (light.counted) {
            const glm::dvec3& value = light.addend.value;
            strengths.emplace_back(-(std::abs(value.x) + std::abs(value.y) + std::abs(value.z)),
                                   light.number);
        }
    std::sort(strengths.begin(), strengths.end());
    strengths.resize(std::min(count, strengths.size()));
    std::vector<int> numbers;
    for (const auto& [strength, number] : strengths)
        numbers.push_back(number);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::vector<std::string> probeRemarks(const ProbeReport& report, Language language) {
    std::vector<std::string> remarks;
    const auto remark = [&](const Text& text) { remarks.emplace_back(say(text, language)); };
    const auto& probe = report.probe;
    if (probe.mesh == nullptr) {
        remark({"sfondo: qui non c'è nessuna superficie", "background: there is no surface here"});
        return remarks;
    }
    if (report.sight != Sight::visible)
        remark(sightText(report.sight));
    if (!probe.lit) {
        remark({"materiale non illuminato: P è il suo colore, nessuna luce lo raggiunge",
                "unlit material: P is its colour, no light reaches it"});
        return remarks;
    }
    if (probe.n == glm::dvec3(0))
        remark({"nessuna normale: ogni n·ω è 0", "no normal: every n·ω is 0"});
    else if (probe.flat)
        remark({"la normale è quella del triangolo", "the normal is the triangle's own"});
    if (!probe.front)
        remark({"è il retro: la normale è girata verso chi guarda", "the back: its normal is turned round"});
    if (probe.corners)
        remark({"per vertice: P è interpolato tra i tre vertici; le righe sono calcolate nel punto",
                "per vertex: P is interpolated between the three corners; the rows are the point's own"});
    for (const ProbeLight& light : report.lights)
        if (inThePoint(light))
            remarks.push_back(lightTitle(light.number, light.name, language) +
                              say({" è nel punto stesso: non ha direzione e non aggiunge nulla",
                                   " is in the very point: it has no direction and adds nothing"},
                                  language));
    if (report.switches.normals == lighting::NormalTransform::model)
        remark({"normali trasformate dalla matrice del modello", "normals taken along by the model matrix"});
    if (report.lights.empty() && report.ambientLights.empty())
        remark({"nessuna luce", "no light"});
    return remarks;
}

std::vector<Line> probeLines(const ProbeReport& report, Language language, std::size_t lights) {
    std::vector<Line> lines;
    lines.push_back(
        {{"pixel " + whereIs(report, language) + say({", spazio mondo", ", world space"}, language),
          Tone::title}});
    if (report.probe.mesh != nullptr)
        lines.push_back({{report.mesh, Tone::title}});
    for (const std::string& remark : probeRemarks(report, language))
        lines.push_back({{remark, Tone::idle}});
    if (report.probe.mesh != nullptr) {
        const bool albedoOff = report.probe.lit && !report.on(Term::albedo);
        const glm::dvec3 D = albedoOff ? glm::dvec3(1) : report.probe.D;
        lines.push_back({{"Q", Tone::title},
                         {shortText(dusted(report.probe.Q, std::abs(report.probe.depth))), Tone::plain}});
        lines.push_back({{"n", Tone::title}, {shortText(report.probe.n), Tone::plain}});
        lines.push_back({{"D", Tone::title},
                         {colorText(D) + off(albedoOff, language), albedoOff ? Tone::idle : Tone::plain}});
    }
    if (!report.lights.empty())
        addLights(report, language, lights, lines);
    addSums(report, language, lines);
    return lines;
}

std::string probeText(const ProbeReport& report, Language language) {
    Fields fields(language);
    const auto& probe = report.probe;
    fields.add("pixel", whereIs(report, language));
    fields.add("space", say({"mondo", "world"}, language));
    if (probe.mesh != nullptr) {
        fields.add("mesh", harmless(report.mesh));
        fields.add("triangle", std::to_string(probe.triangle));
        fields.add("seen", say(sightText(report.sight), language));
        fields.add("Q", dusted(probe.Q, std::abs(probe.depth)));
        fields.add("n", probe.n);
        fields.add("v", probe.v);
        fields.add("D", report.on(Term::albedo) || !probe.lit ? probe.D : glm::dvec3(1),
                   report.on(Term::albedo) || !probe.lit);
    }
    for (const ProbeLight& light : report.lights)
        addLight(report, light, language, fields);
    if (probe.lit) {
        fields.add("L_A", report.ambientLight);
        fields.add("ambient", probe.ambient, report.on(Term::ambient));
        fields.add("emitted", probe.emitted);
        if (report.shines())
            fields.add("highlight", highlightOf(report), report.on(Term::specular));
    }
    if (probe.corners)
        for (std::size_t i = 0; i < 3; ++i) {
            fields.add("corner " + std::to_string(i + 1) + " weight", probe.weights[static_cast<int>(i)]);
            fields.add("corner " + std::to_string(i + 1) + " P", (*probe.corners)[i] + probe.emitted);
        }
    fields.add("P", probe.P);
    fields.add("clamped", report.clamped);
    fields.add("code", codes(report.code));
    if (report.drawn) {
        fields.add("drawn", codes(*report.drawn));
        fields.add("difference", differenceOf(report));
    }
    for (const std::string& remark : probeRemarks(report, language))
        fields.add("remark", harmless(remark));
    return fields.text();
}

}  // namespace lab
