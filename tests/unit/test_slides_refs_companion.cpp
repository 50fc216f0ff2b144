// The companion of slides_refs/: a question with its answer and a picture for every slide, in both languages.
// SPDX-License-Identifier: MIT
#include "unit/test_slides_refs.hpp"

#include <regex>
#include <sstream>

namespace {

using namespace slides_refs;
namespace fs = std::filesystem;

// Every text of slides.json in this language, with its path.
void collect(const json& value, const std::string& language, const std::string& path,
             std::map<std::string, std::string>& into) {
    if (value.is_object() && value.contains(language) && value[language].is_string()) {
        into[path] = value[language].get<std::string>();
    } else if (value.is_structured()) {
        for (const auto& [name, member] : value.items()) {
            collect(member, language, path + "/" + name, into);
        }
    }
}

Strings wordsOf(const std::string& command) {
    std::istringstream stream(command);
    return {std::istream_iterator<std::string>(stream), {}};
}

TEST(SlidesRefsCompanion, EverySlideAsksAndAnswers) {
    for (const json& slide : refs().at("slides")) {
        const json& predict = slide.at("predict");
        expectBilingual(predict.at("question"), slideName(slide) + ".predict.question");
        expectBilingual(predict.at("answer"), slideName(slide) + ".predict.answer");
        for (const json& question : predict.at("question")) {
            EXPECT_EQ(question.get<std::string>().back(), '?') << slideName(slide);
        }
    }
}

TEST(SlidesRefsCompanion, EverySlideShowsOneToThreePicturesThatExist) {
    for (const json& slide : refs().at("slides")) {
        const json& pictures = slide.at("pictures");
        EXPECT_GE(pictures.size(), 1U) << slideName(slide);
        EXPECT_LE(pictures.size(), 3U) << slideName(slide);
        for (const json& picture : pictures) {
            const auto file = picture.at("file").get<std::string>();
            EXPECT_TRUE(std::regex_match(file, std::regex(R"(slide_\d\d_\w+\.png)"))) << file;
            expectBilingual(picture.at("alt"), file + ".alt");
            EXPECT_TRUE(fs::exists(root + "/slides_refs/pictures/" + file))
                << file << " is missing; draw it with lessons/pictures";
        }
    }
}

TEST(SlidesRefsCompanion, EverySceneFileIsDrawnAndEveryFileDrawnExists) {
    std::set<std::string> named;
    for (const json& slide : refs().at("slides")) {
        for (const json& picture : slide.at("pictures")) {
            for (const std::string& word : wordsOf(picture.at("command"))) {
                if (word.ends_with(".json")) {
                    named.insert(word);
                }
            }
        }
    }
    std::set<std::string> existing;
    for (const auto& entry : fs::directory_iterator(root + "/slides_refs/scenes")) {
        existing.insert("slides_refs/scenes/" + entry.path().filename().string());
    }
    EXPECT_EQ(named, existing);
}

TEST(SlidesRefsCompanion, ItalianHasItsAccents) {
    static const std::regex missing(
        R"((^|[^\w`])(perche|poiche|finche|cioe|piu|puo|cosi|gia|li' |e'|perche'|piu'|cosi'|cioe'|puo'|qual'è|né' )($|[^\w`]))",
        std::regex::icase);
    std::map<std::string, std::string> texts;
    collect(refs(), "it", "", texts);
    EXPECT_GT(texts.size(), 300U);
    for (const auto& [path, text] : texts) {
        std::smatch found;
        EXPECT_FALSE(std::regex_search(text, found, missing))
            << path << ": \"" << found.str() << "\" in " << text;
    }
}

TEST(SlidesRefsCompanion, BothLanguagesGiveTheSameNumbers) {
    std::map<std::string, std::string> italian;
    std::map<std::string, std::string> english;
    collect(refs().at("slides"), "it", "", italian);
    collect(refs().at("slides"), "en", "", english);
    ASSERT_EQ(italian.size(), english.size());
    static const std::regex number(R"(\d+(?:[.,]\d+)?)");
    const auto numbersOf = [](const std::string& text) {
        std::multiset<std::string> numbers;
        for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
            std::string digits = at->str();
            std::replace(digits.begin(), digits.end(), ',', '.');
            numbers.insert(digits);
        }
        return numbers;
    };
    for (const auto& [path, text] : italian) {
        EXPECT_EQ(numbersOf(text), numbersOf(english.at(path))) << path;
    }
}

}  // namespace
