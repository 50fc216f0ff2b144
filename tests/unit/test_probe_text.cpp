// The probe in words: the line, the table, the equation with numbers.
// SPDX-License-Identifier: MIT
#include "lab/live/curves.hpp"
#include "lab/live/equation_numbers.hpp"
#include "lab/live/numbers.hpp"
#include "lab/live/probe_text.hpp"
#include "support/probed.hpp"

#include <algorithm>
#include <deque>
#include <gtest/gtest.h>
#include <random>

namespace {

using lab::Language;
using lab::PanelSymbol;
using lab::ProbeReport;
using lab::Tone;
using lighting::Term;
using lighting::TermSet;
using support::fieldsOf;
using support::Floor;

std::vector<PanelSymbol> numbers(Floor& f, const lighting::Switches& switches = {},
                                 Language language = Language::en) {
    const ProbeReport report = f.middle(switches);
    return lab::equationWithNumbers(report, lab::equation(switches.terms, f.plan()), language);
}

std::string textOf(const std::vector<lab::Line>& lines) {
    std::string text;
    for (const lab::Line& line : lines) {
        for (const lab::Span& span : line)
            text += span.text + " | ";
        text += "\n";
    }
    return text;
}

TEST(Numbers, AsTheyAreWritten) {
    EXPECT_EQ(lab::significant(3 / std::sqrt(13), 6), "0.83205");
    EXPECT_EQ(lab::significant(1e-7, 6), "1e-07");
    EXPECT_EQ(lab::significant(-0.0, 6), "0");
    EXPECT_EQ(lab::shortText(0.619), "0.62");
    EXPECT_EQ(lab::shortText(-0.001), "-0.001");
    EXPECT_EQ(lab::shortText(0.0374), "0.037");
    EXPECT_EQ(lab::shortText(1), "1");
    EXPECT_EQ(lab::shortText(-0.0), "0");
    EXPECT_EQ(lab::shortText(1e30), "1e+30");
    EXPECT_EQ(lab::shortText(glm::dvec3(1, 1e-17, -1e-17)), "(1, 0, 0)");
    EXPECT_EQ(lab::colorText({1, 8 / 15.0, 1 / 3.0}), "(1.00, 0.53, 0.33)");
    EXPECT_EQ(lab::colorText({1, 1, 1}), "(1, 1, 1)");
    EXPECT_EQ(lab::colorText({-0.001, 0.5, 0}), "(0.00, 0.50, 0.00)");
}

TEST(ProbeText, ALineThatProgramsRead) {
    Floor f;
    f.floor.name = "a; b\n= c";
    ProbeReport r = f.middle();
    r.drawn = std::array<std::uint8_t, 3>{249, 151, 98};
    const std::string line = lab::probeText(r, Language::en);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    auto fields = fieldsOf(line);
    EXPECT_FALSE(fields.contains("bad")) << fields["bad"];
    EXPECT_EQ(fields["pixel"], "(32, 32)");
    EXPECT_EQ(fields["space"], "world");
    EXPECT_EQ(fields["mesh"], "Mesh 'a  b = c'");
    EXPECT_EQ(fields["n"], "(0, 1, 0)");
    EXPECT_EQ(fields["Q"], "(0, 0, 0)");
    EXPECT_EQ(fields["D"], "(1, 0.533333, 0.333333)");
    EXPECT_EQ(fields["light 1"], "directional 'sun'");
    EXPECT_EQ(fields["light 1 w"], "(0, 0.83205, -0.5547)");
    EXPECT_EQ(fields["light 1 n.w"], "0.83205");
    EXPECT_EQ(fields["light 2"], "point");
    EXPECT_EQ(fields["light 2 d"], "5.59017");
    EXPECT_EQ(fields["light 2 f"], "0.032");
    EXPECT_EQ(fields["light 2 L"], "(5, 10, 2.5)");
    EXPECT_EQ(fields["ambient"], "(0.1, 0.106667, 0.1)");
    EXPECT_EQ(fields["P"], "(0.974983, 0.596221, 0.384506)");
    EXPECT_EQ(fields["code"], "(249, 152, 98)");
    EXPECT_EQ(fields["drawn"], "(249, 151, 98)");
    EXPECT_EQ(fields["difference"], "(0, -1, 0)");
    auto italian = fieldsOf(lab::probeText(r, Language::it));
    EXPECT_EQ(italian.size(), fields.size()) << "the same names";
    EXPECT_EQ(italian["light 1"], "direzionale 'sun'");
}

TEST(ProbeText, WhatIsOffSaysSo) {
    Floor f;
    f.bulb.position.set(2, -1.5, 5);
    auto fields = fieldsOf(lab::probeText(f.middle(TermSet::none().with(Term::point)), Language::en));
    EXPECT_EQ(fields["light 1"], "directional 'sun' (off)");
    EXPECT_EQ(fields["light 2 n.w"], "1 (off)");
    EXPECT_EQ(fields["light 2 f"], "1 (off)");
    EXPECT_EQ(fields["light 2 L"], "(10, 10, 10) (off)");
    EXPECT_EQ(fields["D"], "(1, 1, 1) (off)");
    EXPECT_EQ(fields["ambient"], "(0, 0, 0) (off)");
    EXPECT_EQ(fields["P"], "(10, 10, 10)");
    fields = fieldsOf(lab::probeText(f.middle(TermSet::all().without(Term::clamp)), Language::it));
    EXPECT_EQ(fields["light 2 max"], "-0.268328 (spento)");
    EXPECT_EQ(fields["light 2 n.w"], "-0.268328");
    fields = fieldsOf(lab::probeText(f.middle(), Language::en));
    EXPECT_EQ(fields["light 2 n.w"], "-0.268328");
    EXPECT_EQ(fields["light 2 max"], "0");
}

TEST(ProbeText, ATableForThePanel) {
    Floor f;
    ProbeReport r = f.middle(TermSet::all().without(Term::attenuation));
    r.drawn = std::array<std::uint8_t, 3>{255, 255, 90};
    const std::vector<lab::Line> lines = lab::probeLines(r, Language::en);
    const std::string text = textOf(lines);
    const auto row = [&lines](const std::string& name) {
        for (const lab::Line& line : lines)
            if (line.front().text == name)
                return textOf({line});
        return "no row " + name;
    };
    EXPECT_EQ(row("light").find("light | light 1 'sun' | light 2"), 0U) << text;
    EXPECT_EQ(row("ω").find("ω | (0, 0.832, -0.555) | "), 0U) << text;
    EXPECT_EQ(row("n·ω").find("n·ω | 0.8321 | "), 0U) << text;
    EXPECT_EQ(row("f(d)").find("f(d) | 1 | 1 (off)"), 0U) << text;
    EXPECT_EQ(row("d").find("d | - | 5.59"), 0U) << text;
    EXPECT_EQ(row("diffuse").find("diffuse | (0.832, "), 0U) << text;
    EXPECT_NE(text.find("world space"), std::string::npos);
    // What the driver drew is told below the code, and as wrong where it is.
    EXPECT_EQ(row("GPU").find("GPU | (255, 255, 90)"), 0U) << text;
    EXPECT_EQ(lines.back().at(1).tone, Tone::wrong);
    const auto header = std::find_if(lines.begin(), lines.end(),
                                     [](const lab::Line& line) { return line.front().text == "light"; });
    ASSERT_NE(header, lines.end());
    EXPECT_EQ(header->size(), (header + 1)->size());
}

TEST(ProbeText, WhatIsSpecialIsTold) {
    Floor f;
    const auto remarks = [&f](const lighting::Switches& switches = {}) {
        std::string all;
        for (const std::string& remark : lab::probeRemarks(f.middle(switches), Language::en))
            all += remark + "\n";
        return all;
    };
    EXPECT_EQ(remarks(), "");
    f.see();
    const lab::SurfacePoint pin = *f.prober.point(32, 32);
    f.bulb.position = f.prober.at(pin)->probe.Q;
    f.see();
    EXPECT_EQ(lab::probeRemarks(*f.prober.at(pin), Language::en),
              std::vector<std::string>{"light 2 is in the very point: it has no direction and adds nothing"});
    f.bulb.position.set(2, 1.5, 5);
    lighting::Switches switches;
    switches.shading = lighting::Shading::vertex;
    EXPECT_NE(remarks(switches).find("interpolated between the three corners"), std::string::npos);
    switches.shading = lighting::Shading::flat;
    EXPECT_NE(remarks(switches).find("the triangle's own"), std::string::npos);
    f.paint.side = THREE::BackSide;
    f.camera.position.set(0, -2, 3);
    f.camera.lookAt(0, 0, 0);
    EXPECT_NE(remarks().find("the back"), std::string::npos);
    f.sheet.attributes.erase("normal");
    f.sheet.needsUpdate();
    EXPECT_NE(remarks().find("the triangle's own"), std::string::npos);
    f.sheet.setAttribute("normal", std::vector<double>(12, 0), 3);
    EXPECT_NE(remarks().find("no normal"), std::string::npos);
    for (THREE::Object3D* const light : std::vector<THREE::Object3D*>{&f.sun, &f.bulb, &f.sky})
        f.scene.remove(*light);
    EXPECT_NE(remarks().find("no light"), std::string::npos);
    f.scene.remove(f.floor);
    EXPECT_NE(remarks().find("background"), std::string::npos);
}

TEST(EquationWithNumbers, AsOnTheBlackboard) {
    Floor f;
    const std::vector<PanelSymbol> symbols = numbers(f);
    EXPECT_EQ(lab::equationText(symbols),
              "P = ( max(0, 0.83) · 1 · (1.00, 0.53, 0.33) ⊗ (1, 1, 1) + max(0, 0.27) · 0.032 · "
              "(1.00, 0.53, 0.33) ⊗ (5.00, 10.00, 2.50) ) + (1.00, 0.53, 0.33) ⊗ (0.10, 0.20, 0.30) = "
              "(0.97, 0.60, 0.38)");
    const auto cosine =
        std::find_if(symbols.begin(), symbols.end(), [](const PanelSymbol& s) { return s.text == "0.27"; });
    ASSERT_NE(cosine, symbols.end());
    EXPECT_EQ(cosine->command, "term cosine toggle");
    EXPECT_EQ(cosine->tone, Tone::active);
    EXPECT_NE(cosine->help.find("light 2"), std::string::npos);
}

TEST(EquationWithNumbers, NeutralElementsWhereTermsAreOff) {
    Floor f;
    const TermSet on = TermSet::all().without(Term::cosine).without(Term::albedo).without(Term::directional);
    const std::vector<PanelSymbol> symbols = numbers(f, on.without(Term::ambient));
    EXPECT_EQ(lab::equationText(symbols),
              "P = ( max(0, 1) · 0.032 · (1, 1, 1) ⊗ (5.00, 10.00, 2.50) + 0 ) + 0 = (0.16, 0.32, 0.08)");
    for (const PanelSymbol& symbol : symbols)
        if (symbol.command == "term cosine toggle" || symbol.command == "term directional toggle" ||
            symbol.command == "term ambient toggle") {
            EXPECT_EQ(symbol.tone, Tone::off) << symbol.text;
        }
}

TEST(EquationWithNumbers, OfManyLightsTheBrightest) {
    Floor f;
    std::deque<THREE::DirectionalLight> more;
    for (int i = 0; i < 5; ++i) {
        f.scene.add(more.emplace_back(THREE::Color(1, 1, 1), i == 3 ? 9.0 : 0.01));
        more.back().position.set(0, 1, 0);
    }
    const std::string text = lab::equationText(numbers(f));
    EXPECT_NE(text.find("max(0, 0.83) · 1 · (1.00, 0.53, 0.33) ⊗ (1, 1, 1) + max(0, 1) · 1 · "
                        "(1.00, 0.53, 0.33) ⊗ (9, 9, 9) + ... (5 more) )"),
              std::string::npos)
        << text;
    EXPECT_EQ(lab::brightestLights(f.middle(), 2), (std::vector<int>{1, 7}));
    const std::string table = textOf(lab::probeLines(f.middle(), Language::en, 2));
    EXPECT_NE(table.find("+ 5 more lights"), std::string::npos) << table;
}

TEST(EquationWithNumbers, PerVertexUnlitAndNothing) {
    Floor f;
    lighting::Switches switches;
    switches.shading = lighting::Shading::vertex;
    EXPECT_EQ(lab::equationText(numbers(f, switches)).find("P = 0.50 · ("), 0U)
        << "the origin is in the middle of a diagonal";
    THREE::MeshBasicMaterial plain(THREE::Color(0.5, 0.25, 0.125));
    f.floor.material = plain;
    EXPECT_EQ(lab::equationText(numbers(f)), "P = (0.50, 0.25, 0.12)");
    f.scene.remove(f.floor);
    EXPECT_EQ(lab::equationText(numbers(f)), "P = (0, 0, 0)");
}

TEST(Curves, ThePointIsOnThem) {
    Floor f;
    f.paint.specular = THREE::Color(1, 1, 1);
    f.paint.shininess = 4;
    const ProbeReport r = f.middle();
    EXPECT_EQ(lab::pointCurves(r, 1, Language::en).size(), 2U) << "a directional light has no f(d)";
    const auto curves = lab::pointCurves(r, 2, Language::en);
    ASSERT_EQ(curves.size(), 3U);
    EXPECT_NEAR(curves[0].dot.x * 180, std::acos(1.5 / std::sqrt(31.25)) * 180 / std::acos(-1.0), 1e-9);
    EXPECT_NEAR(curves[0].dot.y, 1.5 / std::sqrt(31.25), 1e-9);
    EXPECT_EQ(curves[1].title, "f(d) = 1 / d^2");
    EXPECT_EQ(curves[1].dotText, "f(5.59) = 0.032");
    EXPECT_NEAR(curves[1].dot.x, 0.5, 1e-9);
    EXPECT_NEAR(curves[1].dot.y, 1 / 1.5, 1e-9);
    for (const lab::PanelCurve& curve : curves) {
        double nearest = 1;
        for (const lab::PanelPoint& p : curve.line)
            nearest = std::min(nearest, std::hypot(p.x - curve.dot.x, p.y - curve.dot.y));
        EXPECT_LT(nearest, 0.02) << curve.title;
    }
    // Twice as far a quarter of the light: the curve's right end.
    EXPECT_NEAR(curves[1].line.back().y, curves[1].dot.y / 4, 1e-9);
    f.bulb.distance = 6;
    EXPECT_NE(lab::pointCurves(f.middle(), 2, Language::en)[1].title.find("window"), std::string::npos);
    EXPECT_EQ(lab::pointCurves(f.middle(), 2, Language::en)[1].line.back().y, 0);
}

// Scenes that are valid and still odd: no text with nan or inf, no place outside the diagrams.
TEST(ProbeText, NothingIsNotANumber) {
    std::mt19937 random(7);
    const double odd[] = {0, 1, -1, 0.5, 1e-30, 1e-12, 1e6, 3};
    const auto any = [&] { return odd[random() % 8]; };
    for (int i = 0; i < 400; ++i) {
        Floor f;
        f.floor.scale.set(any(), 1, 1);
        f.bulb.position.set(any(), std::abs(any()), any());
        f.bulb.decay = std::abs(any());
        f.bulb.distance = std::abs(any());
        f.sun.position.set(any(), 1, any());
        f.paint.specular = THREE::Color(std::abs(any()), 0, 1);
        f.paint.shininess = std::abs(any());
        f.paint.specularModel = i % 2 == 0 ? THREE::SpecularModel::phong : THREE::SpecularModel::blinn;
        lighting::Switches switches(
            lighting::parseTerms(i % 3 == 0 ? "all" : "-clamp,-cosine", TermSet::all()));
        switches.shading = static_cast<lighting::Shading>(i % 3);
        f.see(switches);
        for (const std::optional<ProbeReport>& r :
             {f.prober.at(32, 32), f.prober.at(lab::SurfacePoint{&f.floor, 0, {0.25, 0.25, 0.5}})}) {
            if (!r)
                continue;
            const std::string text =
                lab::probeText(*r, Language::en) + textOf(lab::probeLines(*r, Language::it)) +
                lab::equationText(
                    lab::equationWithNumbers(*r, lab::equation(switches.terms, f.plan()), Language::en));
            EXPECT_EQ(text.find("nan"), std::string::npos) << text;
            EXPECT_EQ(text.find("inf"), std::string::npos) << text;
            for (const lab::PanelCurve& curve : lab::pointCurves(*r, {}, Language::en))
                for (const lab::PanelPoint& p : curve.line)
                    ASSERT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1) << curve.title;
        }
    }
}

}  // namespace
