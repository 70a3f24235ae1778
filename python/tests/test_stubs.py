"""The stubs name what the module has, with the same arguments."""

import ast
import inspect

import assur
from conftest import ROOT

STUBS = ast.parse((ROOT / "python" / "assur.pyi").read_text(encoding="utf-8"))
# What every class has, or Python itself asks for.
PLAIN = {"__doc__", "__module__", "__new__", "__repr__", "__weakref__"}


def arguments(function):
    every = function.args.posonlyargs + function.args.args + function.args.kwonlyargs
    return [argument.arg for argument in every if argument.arg != "self"]


def own(name):
    return {member for member in vars(getattr(assur, name)) if member not in PLAIN}


def test_stubs_and_module_have_the_same_names():
    public = {name for name in dir(assur) if not name.startswith("_") and name != "assur"}
    stubs = {node.name: node for node in STUBS.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert set(stubs) == public
    for name, node in stubs.items():
        if isinstance(node, ast.FunctionDef):
            assert arguments(node) == list(inspect.signature(getattr(assur, name)).parameters), name
            continue
        members = {one.name: one for one in node.body if isinstance(one, ast.FunctionDef)}
        fields = {one.target.id for one in node.body if isinstance(one, ast.AnnAssign)}
        if name != "Error":
            assert set(members) | fields == own(name), name
        for member, function in members.items():
            found = getattr(getattr(assur, name), member)
            if callable(found) and not member.startswith("__"):
                told = [one for one in inspect.signature(found).parameters if one != "self"]
                assert arguments(function) == told, f"{name}.{member}"
