"""The catalogue's entries: public facts only, each from the source's own page.

Each digest is that of the file in a clone of its repository, at the commit named. Entries with a ``reading``
make the benchmark.
"""

from __future__ import annotations

import difflib

from pointpred.datasets.catalogue import DataSet, github_file
from pointpred.errors import ParameterError
from pointpred.recordings.reading import AS_IS, Reading

SETS: tuple[DataSet, ...] = (
    DataSet(
        "freihaut2021",
        "Point-and-click task of a study on stress",
        "https://github.com/Freihaut/Freihaut_Goeritz-2021-Study_Files-Mouse",
        "GPL-3.0",
        "Freihaut and Goeritz 2021, doi:10.5281/zenodo.3941808",
        35,
        1653,
        "17 ms, millisecond stamps",
        "centre and width 24 px, about 300 px away",
        files=(
            github_file(
                "Freihaut/Freihaut_Goeritz-2021-Study_Files-Mouse",
                "Datasets/Data_LSTM_Analysis/Data_PointClick_Task.pkl",
                "b21812dc215de6cf1409c8d3b5b1c24547bc8a95",
                "4089b47b555ad2944da5ac645f970dcb4ff0041ccda835f9b7f0d694549eedd7",
            ),
        ),
        note="A Python pickle can run code when opened: pointpred never opens it. Read it with a restricted "
        "unpickler only.",
    ),
    DataSet(
        "pvplib23714",
        "ISO circle and random targets with a touchpad and a controller",
        "https://github.com/jgori-ouistiti/PVPlib",
        "GPL-3.0",
        "PVPlib, J. Gori and others",
        1,
        480,
        "10.09 ms, equispaced",
        "centre and width 14-124 px, 193-1401 px away",
        files=(
            github_file(
                "jgori-ouistiti/PVPlib",
                "tests/23714_fusion.json",
                "e18f6b55e9b27d3cf0f10394bf4d1f2316c355c7",
                "afe7b3fe9ed466413904a05a5af45f5bbd6de6d696dd1c84de5300b3843d34e0",
            ),
        ),
    ),
    DataSet(
        "cryslacks",
        "Free movements between large squares",
        "https://github.com/Cryslacks/Human-Mouse-Movement-Simulator",
        "MIT, 2021 David Eriksson",
        "Human-Mouse-Movement-Simulator, D. Eriksson 2021",
        1,
        2261,
        "nominally 1 ms, really 1.0-1.3 ms; 559 trials at 10 ms",
        "a square of 300 px, centre unknown",
        files=(
            github_file(
                "Cryslacks/Human-Mouse-Movement-Simulator",
                "pytorch/data/1.5k_1ms.txt",
                "5b480d12da6a0644527668c8d3c04e5aa6df2f6e",
                "99f8d0c8688bed340058f4ff7e785cf6560b290701e9762689b8fae8a2830250",
            ),
            github_file(
                "Cryslacks/Human-Mouse-Movement-Simulator",
                "AMM-AugmentedMouseMovement/test200_1ms.txt",
                "5b480d12da6a0644527668c8d3c04e5aa6df2f6e",
                "c9086c0fa198156d4c5ca8feaaeb7a812c8b21bfb980972843dee0c1a813e24d",
            ),
        ),
        note="The trials at 10 ms lie in further files of AMM-AugmentedMouseMovement.",
    ),
    DataSet(
        "kh2017",
        "Choice between two answers, mouse-tracking",
        "https://github.com/PascalKieslich/mousetrap-resources",
        "GPL-3, as shipped in the R package mousetrap",
        "Kieslich and Henninger 2017, Behavior Research Methods",
        60,
        1140,
        "10 ms",
        "the click is known, the button is not",
        importer="mousetrap",
        files=(
            github_file(
                "PascalKieslich/mousetrap-resources",
                "KieslichHenninger2017/merged_data/raw_data.csv.gz",
                "a6f90967b413bed692dc7c8308c6b629a0649de3",
                "fb2557d73e31e3a6aa929c9d1b44284d570dd64a672275c30e70a7e33302b6fb",
            ),
        ),
        reading=AS_IS,
    ),
    DataSet(
        "humanmovemouse",
        "Movements to known endpoints",
        "https://github.com/TomokotoKiyoshi/HumanMoveMouse",
        "MIT, 2025 TomokotoKiyoshi",
        "HumanMoveMouse, TomokotoKiyoshi 2025",
        1,
        331,
        "16.5 ms",
        "endpoint known",
        note="A folder of CSV files, csv_data: clone the repository.",
    ),
    DataSet(
        "gofitts_demo",
        "One GoFitts block, ISO circle",
        "https://github.com/ChrisVeigl/PlotFittsTrace",
        "MIT, 2023 Chris Veigl",
        "PlotFittsTrace, C. Veigl 2023; GoFitts, I. S. MacKenzie",
        1,
        81,
        "8 ms",
        "centre, width 20/40/80 px, 100/200/400 px away",
        importer="gofitts",
        files=(
            github_file(
                "ChrisVeigl/PlotFittsTrace",
                "demo/FittsTask-P50-C00-S00-G00-2D-MB-B02.sd3",
                "1eb6949be01b296a9fe15a567818e5345d2ab044",
                "3fd86c0b0f7d4236256aeda46f962c66de558fb1a39b8bba8837c91441826e5c",
            ),
        ),
        reading=AS_IS,
    ),
    DataSet(
        "jrcalgo",
        "Free movements with clicks",
        "https://github.com/jrcalgo/generative-mouse-trajectories",
        "MIT, 2024 jrcalgo",
        "generative-mouse-trajectories, jrcalgo 2024",
        1,
        302,
        "16 ms, stamps in bursts",
        "click known",
        files=(
            github_file(
                "jrcalgo/generative-mouse-trajectories",
                "data/mouse_data_20250813_235208.csv",
                "a4560d02b8425b61673428d7d9860a4743ba7beb",
                "2b2d051f97a713f426cb901d846ea9d9570a80daf3db5481c4ca4ce1ebae8397",
            ),
            github_file(
                "jrcalgo/generative-mouse-trajectories",
                "data/mouse_data_20260203_112701.csv",
                "a62b4af8aeae542fa8ed0a716ad32480f5fbe065",
                "7294d2b8e7474a293041bfa42caf4eaed1668d08403455cd763c5ea5cf09b959",
            ),
            github_file(
                "jrcalgo/generative-mouse-trajectories",
                "data/mouse_data_20260206_204924.csv",
                "aba28c3882c13e7ec592371f030a2c18c62e5f3f",
                "4e2e87fc1c74e9a1ced1404d256fd4e543a1e8f1eb24f1a9e0fcbfb919f60552",
            ),
        ),
        reading=Reading(
            columns={"t": "timestamp", "x": "position_x", "y": "position_y", "buttons": "click_events"},
            time_unit="s",
            cut="clicks",
        ),
        people="folder",
    ),
    DataSet(
        "evemu_mice",
        "Raw counts of real mice, kernel stamps",
        "https://github.com/whot/evemu-devices",
        "MIT-style, 2012-2013 Red Hat",
        "evemu-devices, P. Hutterer and others",
        None,
        None,
        "microsecond stamps of the kernel, raw relative counts",
        "none",
        importer="evemu",
        files=(
            github_file(
                "whot/evemu-devices",
                "mice/PS2 Generic Mouse.events",
                "368e30804d58b7c57b2b1058dbb67fefca03a8ae",
                "764d192206d2d5179070c669b04b00f28a490b949b42bb8c9564a8096572ea96",
            ),
            github_file(
                "whot/evemu-devices",
                "mice/Saitek Cyborg R.A.T.5 Mouse.events",
                "ad1f3628657316eb9f3f95d1c05b54ab7b478fdb",
                "657bceb1622d9d2e916457d0c625ff1221470d2621f6f6e4be105d5729d4889e",
            ),
            github_file(
                "whot/evemu-devices",
                "mice/Ultrathin Touch Mouse.events",
                "a69498f0eeded27b56b74be59617ecb0ba955206",
                "18fa4cc432d9480ffe4e50a45ad0a231d9286df4a045c943792f93108b6d90c1",
            ),
        ),
    ),
    DataSet(
        "pointing-dynamics",
        "Pointing Dynamics Dataset: reciprocal pointing in one dimension",
        "https://research.aalto.fi/en/publications/control-theoretic-models-of-pointing",
        "not recorded here: see the authors' page",
        "Mueller, Oulasvirta and Murray-Smith 2017, ACM TOCHI 24(4), article 27",
        12,
        7732,
        "500 Hz",
        "distance and width known",
        importer="pointing-dynamics",
        note="One file a user, distance and width; positions in metres. Its columns sgv and sga look ahead.",
    ),
    DataSet(
        "sapimouse",
        "SapiMouse: 120 people, free targets, three minutes and one minute each",
        "https://ms.sapientia.ro/~manyi/sapimouse/sapimouse.html",
        "not recorded here: see the authors' page",
        "Antal, Fejer and Buza 2021, SapiMouse",
        120,
        None,
        "millisecond stamps",
        "none",
        importer="balabit",
    ),
    DataSet(
        "balabit",
        "Balabit Mouse Dynamics Challenge: remote desktop sessions",
        "https://github.com/balabit/Mouse-Dynamics-Challenge",
        "not recorded here: see the repository",
        "Fulop, Kovacs, Kurics and Windhager-Pokol 2016",
        10,
        None,
        "stamps in seconds, as a network device saw them",
        "none",
        importer="balabit",
        note="Clone the repository. Stamps repeat and 65535 stands for a position that is not there.",
    ),
    DataSet(
        "ktm-logs",
        "Logs of the collector published with kinematic template matching",
        "https://depts.washington.edu/acelab/proj/ktm/",
        "the program is New BSD; logs belong to the people they record",
        "Pasqual and Wobbrock 2014, ACM CHI",
        None,
        None,
        "as the collector's machine delivers",
        "centre and width",
        note="Not a published set: run the collector, keep the logs.",
    ),
)


def listing() -> tuple[DataSet, ...]:
    """Every set of the catalogue; none of them is part of this package.

    >>> [entry.name for entry in listing()][:3]
    ['freihaut2021', 'pvplib23714', 'cryslacks']
    """
    return SETS


def find(name: str) -> DataSet:
    """The set of this name; raises ParameterError naming the nearest one and all of them."""
    known = {entry.name: entry for entry in listing()}
    if name in known:
        return known[name]
    near = difflib.get_close_matches(name, known, 1)
    hint = f"; did you mean {near[0]!r}?" if near else "."
    raise ParameterError(f"unknown data set {name!r}{hint} Known: {', '.join(known)}")
