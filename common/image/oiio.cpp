// The module that knows OpenImageIO: every format but PNG and EXR out, every format in.
// SPDX-License-Identifier: MIT
#include "image/oiio.hpp"

#include "image/encoders.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

namespace image {

namespace {

constexpr int largestRead = 16384;
// Beyond it the JPEG writer ends the process, and the GIF writer keeps 16 bits of the size.
constexpr int largestWritten = 65500;

// One text for the formats that have no named texts of their own.
std::string description(const Metadata& metadata) {
    std::string text;
    for (const auto& [key, value] : metadata) {
        text += (text.empty() ? "" : "\n") + key + ": " + value;
    }
    return text;
}

std::string says(const std::string& reason) {
    return "OpenImageIO says: " + (reason.empty() ? "nothing of use" : reason);
}

std::unique_ptr<OIIO::ImageOutput> createOutput(const std::string& extension) {
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("frame" + extension);
    // JPEG 2000's writer reports success where it has encoded nothing, as for every side below 32.
    if (output == nullptr || !output->supports("ioproxy") ||
        output->format_name() == std::string("jpeg2000")) {
        static_cast<void>(OIIO::geterror());  // taken, else OpenImageIO prints it at exit
        throw Error(
            "no format that can be written has the extension " + extension +
            "; expected .png, .exr, .tif, .jpg, .hdr, .bmp, .tga, .ppm, .webp, .gif or .dpx; choose one");
    }
    return output;
}

void encode(const std::string& extension, const Frame& frame, const Metadata& metadata,
            std::vector<unsigned char>& encoded) {
    if (std::max(frame.width, frame.height) > largestWritten) {
        throw Error(
            "the frame is larger than " + std::to_string(largestWritten) +
            " one way; expected a size that most formats hold; write .png or .exr, or make it smaller");
    }
    // Outlives the output, which may write when it is destroyed.
    OIIO::Filesystem::IOVecOutput memory(encoded);
    const std::unique_ptr<OIIO::ImageOutput> output = createOutput(extension);
    output->set_ioproxy(&memory);
    const bool bytes = std::holds_alternative<Bytes>(frame.pixels);
    OIIO::ImageSpec spec(frame.width, frame.height, 3, bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    // Without one the clock's is written: the same frame gives the same bytes.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    if (!metadata.empty()) {
        spec.attribute("ImageDescription", description(metadata));
    }
    const std::string next = "; expected a picture that the format can hold; try .png or .exr";
    if (!output->open("frame" + extension, spec)) {
        throw Error(says(output->geterror()) + next);
    }
    // The plugin has replaced a type that its format cannot hold. Whole numbers hold no NaN: toBytes refuses
    // it.
    const OIIO::TypeDesc held = output->spec().format;
    const Bytes codes = held.is_floating_point() && !bytes ? Bytes() : toBytes(frame);
    const bool written =
        bytes || held == OIIO::TypeDesc::UINT8
            ? output->write_image(OIIO::TypeDesc::UINT8, codes.data())
            : output->write_image(OIIO::TypeDesc::FLOAT, std::get<Floats>(frame.pixels).data());
    if (!written || !output->close()) {
        throw Error(says(output->geterror()) + next);
    }
}

std::unique_ptr<OIIO::ImageInput> open(const std::string& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::is_regular_file(status)) {
        const std::string reason = error ? error.message() : "it is not a regular file";
        throw Error(reason + "; expected a picture file; check the path");
    }
    OIIO::ImageSpec hints;
    hints["oiio:UnassociatedAlpha"] = 1;  // else OpenImageIO multiplies colours by alpha
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &hints);
    if (input == nullptr) {
        throw Error(OIIO::geterror() +
                    "; expected a picture that OpenImageIO reads; check that it is complete");
    }
    return input;
}

void checkReadable(const OIIO::ImageSpec& spec) {
    const std::string size = std::to_string(spec.width) + "x" + std::to_string(spec.height);
    if (spec.width < 1 || spec.height < 1 || spec.width > largestRead || spec.height > largestRead) {
        throw Error("it is " + size + "; expected 1 to " + std::to_string(largestRead) +
                    " each way; make it smaller");
    }
    const bool cropped = spec.width != spec.full_width || spec.height != spec.full_height;
    if (spec.deep || spec.depth > 1 || spec.nchannels < 1 || cropped) {
        throw Error(
            "it is cropped, deep, a volume or without channels; expected one flat picture that fills its " +
            std::string("display window; save it again so"));
    }
}

// First of the three channels to take, or -1 to take channel 0 for all.
int firstColor(const OIIO::ImageSpec& spec) {
    // Not spec.channelindex(), which ends the process where a reader has named too few channels (FITS).
    const std::vector<std::string>& names = spec.channelnames;
    const std::vector<std::string> colors = {"R", "G", "B"};
    const auto found = std::search(names.begin(), names.end(), colors.begin(), colors.end());
    if (found != names.end() && names.size() == static_cast<std::size_t>(spec.nchannels)) {
        return static_cast<int>(found - names.begin());
    }
    return spec.nchannels >= 3 ? 0 : -1;
}

template <typename Number>
std::vector<Number> readPixels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, OIIO::TypeDesc type) {
    std::vector<Number> pixels(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                               3);
    const int first = firstColor(spec);
    const OIIO::stride_t stride = 3 * sizeof(Number);
    const int begin = first < 0 ? 0 : first;
    const int end = first < 0 ? 1 : first + 3;
    if (!input.read_image(0, 0, begin, end, type, pixels.data(), stride)) {
        throw Error(input.geterror() + "; expected a complete picture; write or copy it again");
    }
    for (std::size_t i = 0; first < 0 && i < pixels.size(); i += 3) {
        pixels[i + 1] = pixels[i + 2] = pixels[i];
    }
    return pixels;
}

template <typename Function>
auto naming(const std::string& path, Function read) {
    try {
        return read();
    } catch (const std::exception& error) {
        throw Error("cannot read '" + path + "': " + error.what());
    }
}

}  // namespace

Frame readFrame(const std::string& path) {
    return naming(path, [&path]() -> Frame {
        const std::unique_ptr<OIIO::ImageInput> input = open(path);
        const OIIO::ImageSpec spec = input->spec();
        checkReadable(spec);
        Frame frame = {spec.width, spec.height, {}};
        // Codes are divided by us: OpenImageIO multiplies them by a rounded 1/255.
        if (spec.format == OIIO::TypeDesc::UINT8) {
            frame.pixels = readPixels<std::uint8_t>(*input, spec, OIIO::TypeDesc::UINT8);
            frame.pixels = toFloats(frame);
        } else {
            frame.pixels = readPixels<float>(*input, spec, OIIO::TypeDesc::FLOAT);
        }
        return frame;
    });
}

Metadata readMetadata(const std::string& path) {
    return naming(path, [&path] {
        const std::string prefix = "lambert:";  // of our EXR attributes
        const std::unique_ptr<OIIO::ImageInput> input = open(path);
        Metadata metadata;
        for (const OIIO::ParamValue& attribute : input->spec().extra_attribs) {
            if (attribute.type() == OIIO::TypeDesc::STRING) {
                const std::string name = attribute.name().string();
                metadata.emplace_back(name.starts_with(prefix) ? name.substr(prefix.size()) : name,
                                      attribute.get_string());
            }
        }
        return metadata;
    });
}

}  // namespace image

extern "C" bool lambertImageOiioEncode(const char* extension, const image::Frame* frame,
                                       const image::Metadata* metadata, std::vector<unsigned char>* encoded,
                                       std::string* reason) {
    try {
        image::encode(extension, *frame, *metadata, *encoded);
        return true;
    } catch (const std::exception& error) {
        *reason = error.what();
        return false;
    }
}
