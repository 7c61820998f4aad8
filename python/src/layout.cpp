// SPDX-License-Identifier: GPL-3.0-or-later
#include "layout.hpp"

#include <nanobind/ndarray.h>

#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace nb = nanobind;

namespace hdconj::python {

nb::str text_of(std::string const& text)
{
    return nb::steal<nb::str>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape"));
}

namespace {

nb::list texts_of(std::string const* texts, std::size_t count)
{
    nb::list list;
    for (std::size_t i = 0; i < count; ++i)
        list.append(text_of(texts[i]));
    return list;
}

template <class Number>
nb::object array_of(Number const* values, io::layout::Shape const& shape, io::layout::Owner owner, nb::handle result)
{
    using Array = nb::ndarray<nb::numpy, Number const>;
    std::size_t const count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
    if (owner == io::layout::Owner::result && count > 0)
        return nb::cast(Array(values, shape.size(), shape.data(), result));
    auto copy = std::make_unique<Number[]>(std::max<std::size_t>(count, 1));
    std::copy_n(values, count, copy.get());
    Number* const first = copy.get();
    nb::capsule const keeper(copy.release(), [](void* kept) noexcept { delete[] static_cast<Number*>(kept); });
    return nb::cast(Array(first, shape.size(), shape.data(), keeper));
}

class ObjectGroup final : public io::layout::GroupSink
{
  public:
    explicit ObjectGroup(nb::handle result) : result_(result) {}

    void group(std::string const& name, std::function<void(io::layout::GroupSink&)> const& fill) override
    {
        ObjectGroup inner(result_);
        fill(inner);
        groups_[text_of(name)] = inner.object();
    }
    void dataset(std::string const& name, io::layout::Shape const& shape, io::layout::Values const& values,
                 io::layout::About const& about) override
    {
        nb::object const held = std::visit(
            [&](auto const* first) -> nb::object {
                if constexpr (std::is_same_v<decltype(first), std::string const*>)
                    return texts_of(first, shape.front());
                else
                    return array_of(first, shape, about.owner, result_);
            },
            values);
        nb::list dims;
        for (char const* const dim : about.dims)
            dims.append(dim);
        datasets_[text_of(name)] = nb::make_tuple(held, about.units, text_of(about.meaning), nb::tuple(dims));
    }
    void link(std::string const& name, std::string const& other) override { links_[text_of(other)] = text_of(name); }
    void attribute(std::string const& name, io::layout::AttributeValue const& value) override
    {
        attributes_[text_of(name)] = std::visit(
            [](auto const& given) -> nb::object {
                using Value = std::decay_t<decltype(given)>;
                if constexpr (std::is_same_v<Value, std::string>)
                    return text_of(given);
                else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
                    return texts_of(given.data(), given.size());
                else
                    return nb::cast(given);
            },
            value);
    }
    void figure(io::layout::FigurePlace const& figure) override
    {
        figures_.append(nb::make_tuple(text_of(figure.name), text_of(figure.value), text_of(figure.error), figure.units,
                                       figure.meaning, figure.is_attribute));
    }

    [[nodiscard]] nb::object object() const
    {
        return nb::make_tuple(attributes_, datasets_, links_, groups_, figures_);
    }

  private:
    nb::handle result_;
    nb::dict attributes_, datasets_, links_, groups_;
    nb::list figures_;
};

}  // namespace

nb::object layout_of(Result const& result, nb::handle owner)
{
    ObjectGroup root(owner);
    result.write(io::layout::Writer(root));
    return root.object();
}

}  // namespace hdconj::python
