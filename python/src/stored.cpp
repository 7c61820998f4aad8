// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored.hpp"

#include <nanobind/ndarray.h>

#include "layout.hpp"

namespace nb = nanobind;

namespace hdconj::python {
namespace {

using io::layout::Misfit;

bool has(nb::handle mapping, std::string const& name)
{
    return PyMapping_HasKey(mapping.ptr(), text_of(name).ptr()) != 0;
}

nb::object member(nb::handle mapping, std::string const& name)
{
    if (!has(mapping, name))
        throw Misfit(name + " is missing");
    return mapping[text_of(name)];
}

/// The bytes of a text, which need not be UTF-8.
std::string bytes_of(nb::handle text)
{
    if (!nb::isinstance<nb::str>(text))
        throw Misfit("a value is no text");
    auto const bytes = nb::steal<nb::bytes>(PyUnicode_AsEncodedString(text.ptr(), "utf-8", "surrogateescape"));
    return {bytes.c_str(), bytes.size()};
}

std::vector<std::string> texts_in(nb::handle list)
{
    std::vector<std::string> texts;
    for (nb::handle const text : list)
        texts.push_back(bytes_of(text));
    return texts;
}

template <class Number>
std::vector<Number> numbers_in(nb::handle array, io::layout::Shape& shape)
{
    nb::ndarray<Number const, nb::c_contig, nb::device::cpu> held;
    if (!nb::try_cast(array, held))
        throw Misfit("a dataset holds no numbers");
    for (std::size_t i = 0; i < held.ndim(); ++i)
        shape.push_back(held.shape(i));
    return {held.data(), held.data() + held.size()};
}

}  // namespace

bool PythonGroup::holds(std::string const& name) const
{
    return has(group_.attr("datasets"), name) || has(group_.attr("groups"), name);
}

bool PythonGroup::has_attribute(std::string const& name) const
{
    return has(group_.attr("attrs"), name);
}

io::layout::AttributeValue PythonGroup::attribute(std::string const& name, io::layout::AttributeValue const& like) const
{
    nb::object const value = member(group_.attr("attrs"), name);
    try {
        return std::visit(
            [&](auto const& given) -> io::layout::AttributeValue {
                using Value = std::decay_t<decltype(given)>;
                if constexpr (std::is_same_v<Value, std::string>)
                    return bytes_of(value);
                else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
                    return texts_in(value);
                else
                    return nb::cast<Value>(value);
            },
            like);
    } catch (nb::cast_error const&) {
        throw Misfit(name + " is of another kind");
    }
}

io::layout::StoredValues PythonGroup::dataset(std::string const& name, std::size_t kind, std::size_t rank) const
{
    nb::object const array = member(group_.attr("datasets"), name).attr("values");
    io::layout::StoredValues stored;
    if (kind == 0)
        stored.values = numbers_in<double>(array, stored.shape);
    else if (kind == 1)
        stored.values = numbers_in<int>(array, stored.shape);
    else {
        stored.values = texts_in(array);
        stored.shape = {nb::len(array)};
    }
    if (stored.shape.size() != rank)
        throw Misfit(name + " has the wrong number of dimensions");
    return stored;
}

std::unique_ptr<io::layout::StoredGroup> PythonGroup::group(std::string const& name) const
{
    return std::make_unique<PythonGroup>(member(group_.attr("groups"), name));
}

}  // namespace hdconj::python
