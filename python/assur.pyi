"""Planar linkages by Assur groups: positions, transfer functions, reactions, sweeps.

All numbers are in SI, angles in rad, counter-clockwise. A column has the name that it has in CSV. Arrays of numbers are views of what was
found: nothing is copied, and they can only be read.
"""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.float64]
Texts = Union[str, Sequence[str], Mapping[str, object]]
Columns = Mapping[str, Iterable[Union[str, float]]]

__version__: str

def load(path: Union[str, os.PathLike[str]]) -> Scene:
    """Reads a scene from a file."""

def loads(text: str, file: str = "<text>") -> Scene:
    """Reads a scene from its text; `file` is only repeated in errors."""

class Error(Exception):
    """What is wrong, with its place in the scene where it has one."""

    file: Optional[str]
    """The file, by the name that it was given."""
    line: Optional[int]
    """Line of the first fault, from 1."""
    column: Optional[int]
    """Its column in characters, from 1."""
    key: Optional[str]
    """The key of the scene at that place, such as `link.crank.mass`."""

class Scene:
    """A scene that is read, with its mechanism compiled."""

    @property
    def text(self) -> str:
        """The text of the scene."""
    @property
    def structure(self) -> str:
        """The formula of its structure, such as `I(ground,crank) -> II1(rod,rocker)`."""
    @property
    def points(self) -> list[str]:
        """The names of its points."""
    @property
    def links(self) -> list[str]:
        """The names of its links, the ground among them."""
    @property
    def coordinates(self) -> Numbers:
        """The coordinates of the positions that the scene asks for, rad, m or s."""
    def at(self, coordinate: float) -> Position:
        """The position at a coordinate (rad, m or s) of the input."""
    def replace(self, key: str, value: Union[str, float]) -> Scene:
        """The scene with another value, as text with a unit ("5 kg") or as a number in SI; comments and order stay."""
    def analyze(self, *, positions: Optional[int] = None) -> Results:
        """All results of the positions and of the motion, without checks; `positions`: over so many instead of those of the scene."""
    def sweep(
        self,
        vary: Optional[Texts] = None,
        *,
        points: Optional[Columns] = None,
        measure: Optional[Texts] = None,
        tie: Optional[Texts] = None,
        target: Optional[Texts] = None,
        where: Optional[Texts] = None,
        sample: Optional[int] = None,
        seed: int = 0,
        between: bool = False,
        shard: Optional[tuple[int, int]] = None,
        threads: Optional[int] = None,
    ) -> Table:
        """The scene with many values of its own numbers: a row for each point, as `assur sweep` with the options of these names.

        `vary`, `tie`, `target` and `where` are one text or a list, the first three also a dict: `{"link.crank.mass": "1 kg..5 kg:9"}`.
        `points`, in place of `vary`, has the values of a point in each row: columns by key, as a dict or a data frame; numbers are SI, texts
        have units.
        """

class Position:
    """A mechanism at one coordinate of its input. Derivatives are by that coordinate."""

    @property
    def coordinate(self) -> float:
        """The coordinate, rad, m or s."""
    def point(self, name: str) -> tuple[float, float]:
        """The place of a point, m."""
    def transfer(self, name: str) -> list[tuple[float, float]]:
        """The transfer functions of a point: its place, and the first and second derivative."""
    def link(self, name: str) -> tuple[float, float, float]:
        """The angle of a link in (-pi, pi], rad, and its first and second derivative."""
    def origin(self, name: str) -> tuple[float, float]:
        """The place of the origin of a link, m."""

class Results:
    """The results of a scene."""

    @property
    def positions(self) -> Table:
        """One row for each position that has a solution."""
    @property
    def motion(self) -> Table:
        """One row for each sample of the motion over time, where the scene has one."""
    @property
    def failures(self) -> list[tuple[int, str]]:
        """The positions without a solution: number, and what is missing, where and by how much."""
    @property
    def warnings(self) -> list[str]:
        """What in the scene is probably not meant, and what had to be left out."""
    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        """A column of the positions by its name in CSV, such as `B_x_m`."""
    def reaction(self, pair: str, on: Optional[str] = None) -> Reaction:
        """The force of a pair by its name, on the link on which tables show it; `on`: on that link."""

class Reaction:
    """The force of a pair, row by row."""

    @property
    def on(self) -> str:
        """The link on which the force acts."""
    @property
    def x(self) -> Numbers:
        """Its projection on the x axis of the ground, N."""
    @property
    def y(self) -> Numbers:
        """Its projection on the y axis, N."""
    @property
    def moment(self) -> Optional[Numbers]:
        """The moment of a slide, N m, about its point, counter-clockwise on the link that slides; None of a pin."""

class Table:
    """Rows and columns with names: of positions, of a motion over time, of a sweep. `len` counts the rows."""

    @property
    def names(self) -> list[str]:
        """The names of the columns: those of the CSV, with their units."""
    def keys(self) -> list[str]:
        """The names of the columns, for `dict(table)`."""
    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        """A column by its name: numbers in SI without a copy, NaN where a row has none; texts as an array of texts."""
    def __contains__(self, name: str) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """The table for what reads Arrow, such as `pyarrow.table(table)` and `polars.DataFrame(table)`; empty cells are null."""
