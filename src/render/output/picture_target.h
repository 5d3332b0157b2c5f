// SPDX-License-Identifier: Apache-2.0
// Where a picture goes: to files, to the memory of a file, or to pixels.
#pragma once
#include <optional>
#include <vector>

#include "render/output/picture_files.h"

namespace rakelight {

class PictureTarget {
public:
    virtual ~PictureTarget() = default;
    /// Of its colors.
    virtual PixelFormat format(const RenderSettings& settings) const = 0;
    /// Before the first rows. @param range  the scales of data channels in PNG files
    virtual void open(const RenderSettings& settings, const ChannelRange& range, Context& context) = 0;
    /// All rows come at once, and the target takes them.
    virtual bool takes_whole() const { return false; }
    /// Whether linear colors are wanted beside those of the format.
    virtual bool needs_linear() const { return false; }
    /// The next rows of the picture.
    virtual void write(PictureSink& strip, int rows) = 0;
    /// @return the names of the files of data channels
    virtual std::vector<std::string> finish() { return {}; }

    bool is_linear() const { return format({}).component != Component::u8; }
};

/// The output of a request with its channel files. They are under temporary names until finish().
class FileTarget final : public PictureTarget {
public:
    /// @param memory  where the colors' file goes; null: to its name
    explicit FileTarget(const PictureRequest& request, std::vector<std::byte>* memory = nullptr)
        : output_(request.output),
          channel_files_(request.channel_files),
          half_colors_(request.half_colors),
          memory_(memory) {}
    PixelFormat format(const RenderSettings& settings) const override;
    void open(const RenderSettings& settings, const ChannelRange& range, Context& context) override;
    bool needs_linear() const override { return files_->needs_linear(); }
    void write(PictureSink& strip, int rows) override { files_->write(strip, rows); }
    std::vector<std::string> finish() override;

private:
    std::string output_;
    std::uint32_t channel_files_;
    bool half_colors_;
    std::vector<std::byte>* memory_;
    std::optional<PictureFiles> files_;
};

/// The colors alone, as a PNG file holds them.
class PixelsTarget final : public PictureTarget {
public:
    explicit PixelsTarget(Pixels& pixels) : pixels_(pixels) {}
    PixelFormat format(const RenderSettings& settings) const override;
    void open(const RenderSettings& settings, const ChannelRange& range, Context& context) override;
    bool takes_whole() const override { return true; }
    void write(PictureSink& strip, int) override { pixels_.bytes = strip.take_colors(); }

private:
    Pixels& pixels_;
};

}  // namespace rakelight
