// SPDX-License-Identifier: GPL-3.0-or-later
// What a layout writes, without the numbers: by this a file is read as the layout wrote it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "writer.hpp"

namespace hdconj::io::layout {

/// A dataset as its layout states it.
struct RecordedDataset
{
    std::string name;
    std::size_t kind = 0;  ///< index of the alternative of Values
    std::size_t rank = 0;
    About about;
};

/// A group as its layout states it.
struct RecordedGroup
{
    std::string name;                                                ///< empty: the root
    std::vector<std::pair<std::string, AttributeValue>> attributes;  ///< with a value of the attribute's type
    std::vector<RecordedDataset> datasets;                           ///< in the order written
    std::vector<FigurePlace> figures;
    std::vector<RecordedGroup> groups;  ///< NAME_000 stands for NAME_001 and so on too
};

/// Records what is written into it.
class LayoutRecorder final : public GroupSink
{
  public:
    /// @param group  outlives the object's last call
    explicit LayoutRecorder(RecordedGroup& group) : group_(&group) {}

    void group(std::string const& name, std::function<void(GroupSink&)> const& fill) override
    {
        RecordedGroup made;
        made.name = name;
        LayoutRecorder inner(made);
        fill(inner);
        group_->groups.push_back(std::move(made));
    }
    void dataset(std::string const& name, Shape const& shape, Values const& values, About const& about) override
    {
        group_->datasets.push_back({name, values.index(), shape.size(), about});
    }
    void link(std::string const&, std::string const&) override {}
    void attribute(std::string const& name, AttributeValue const& value) override
    {
        group_->attributes.emplace_back(name, value);
    }
    void figure(FigurePlace const& figure) override { group_->figures.push_back(figure); }

  private:
    RecordedGroup* group_;
};

}  // namespace hdconj::io::layout
