# SPDX-License-Identifier: Apache-2.0
"""Reads a dataset as a stranger would: pyarrow for the tables, FFmpeg for the frames.

read_with_pyarrow.py RECORDER [REFERENCE]

RECORDER FOLDER N records N episodes into FOLDER. REFERENCE is a dataset that lerobot wrote; where it
is given, every schema is compared with its own.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

import pyarrow as pa
import pyarrow.parquet as pq

CAMERA = "observation.images.front"
STATISTICS = ["min", "max", "mean", "std", "count", "q01", "q10", "q50", "q90", "q99"]
ENTRY = ["episode_index", "tasks", "length", "data/chunk_index", "data/file_index",
         "dataset_from_index", "dataset_to_index", f"videos/{CAMERA}/chunk_index",
         f"videos/{CAMERA}/file_index", f"videos/{CAMERA}/from_timestamp",
         f"videos/{CAMERA}/to_timestamp", "meta/episodes/chunk_index", "meta/episodes/file_index"]


def check(condition, what):
    if not condition:
        sys.exit(f"broken: {what}")


def close(a, b, tolerance=1e-6):
    return abs(a - b) <= tolerance * max(1.0, abs(b))


def read_all(folder):
    files = sorted(folder.glob("*/*.parquet"))
    return pa.concat_tables([pq.read_table(file) for file in files])


def probe(video, entries):
    out = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0",
                          "-show_entries", f"stream={entries}", "-of", "json", str(video)],
                         check=True, capture_output=True, text=True).stdout
    return json.loads(out)["streams"][0]


def check_tables(root, info):
    data = read_all(root / "data")
    numbers = {name: f for name, f in info["features"].items() if f["dtype"] != "video"}
    check(data.column_names == list(numbers), "the data columns are the features but the video")
    check(data.num_rows == info["total_frames"], "as many rows as info.json says")
    check(data["index"].to_pylist() == list(range(data.num_rows)), "index counts on")
    for name, feature in numbers.items():
        kind = {"float32": pa.float32(), "float64": pa.float64(), "int64": pa.int64()}
        value, width = kind[feature["dtype"]], feature["shape"][0]
        expected = value if width == 1 else pa.list_(pa.field("element", value), width)
        check(data.schema.field(name).type == expected, f"{name} is {expected}")
        names = feature["names"]
        check(names is None or len(names) == width, f"{name} has as many names as values")
    for row in data.to_pylist():
        check(abs(row["timestamp"] - row["frame_index"] / info["fps"]) < 1e-4, "timestamps")
    return data


def check_episodes(root, info, data):
    episodes = read_all(root / "meta/episodes").to_pylist()
    check(len(episodes) == info["total_episodes"], "as many episodes as info.json says")
    check(info["splits"] == {"train": f"0:{len(episodes)}"}, "splits")
    start = 0
    for i, entry in enumerate(episodes):
        check(all(key in entry for key in ENTRY), "an entry has its columns")
        check(entry["episode_index"] == i and entry["dataset_from_index"] == start, "order")
        check(entry["dataset_to_index"] == start + entry["length"], "length")
        check(close(entry[f"videos/{CAMERA}/to_timestamp"], entry["length"] / info["fps"]), "end")
        rows = data.slice(start, entry["length"])
        check(rows["episode_index"].to_pylist() == [i] * len(rows), "rows of the episode")
        check(rows["frame_index"].to_pylist() == list(range(len(rows))), "frame_index restarts")
        state, action = rows["observation.state"].to_pylist(), rows["action"].to_pylist()
        check(state == [[0.0, 0.0]] + action[:-1], "the state is the action before")
        video = root / info["video_path"].format(
            video_key=CAMERA, chunk_index=entry[f"videos/{CAMERA}/chunk_index"],
            file_index=entry[f"videos/{CAMERA}/file_index"])
        stream = probe(video, "nb_read_frames,width,height,pix_fmt,codec_name,r_frame_rate,"
                              "start_time,has_b_frames")
        height, width, _ = info["features"][CAMERA]["shape"]
        check(int(stream["nb_read_frames"]) == entry["length"], "a frame a row")
        check((stream["width"], stream["height"]) == (width, height), "size of the pictures")
        check(stream["pix_fmt"] == "yuv420p" and stream["codec_name"] == "h264", "codec")
        check(stream["r_frame_rate"] == f"{info['fps']}/1", "rate of the video")
        check(float(stream["start_time"]) == 0.0 and stream["has_b_frames"] == 0, "frame times")
        start += entry["length"]
    return episodes


def check_statistics(root, info, data, episodes):
    stats = json.loads((root / "meta/stats.json").read_text())
    check(set(stats) == set(info["features"]), "every feature has statistics")
    for name, feature in info["features"].items():
        mine = stats[name]
        check(sorted(mine) == sorted(STATISTICS), f"statistics of {name}")
        check(isinstance(mine["count"], list) and len(mine["count"]) == 1, "count is [n]")
        if feature["dtype"] == "video":
            for statistic in STATISTICS:
                if statistic == "count":
                    continue
                shape = [len(mine[statistic]), len(mine[statistic][0]), len(mine[statistic][0][0])]
                check(shape == [3, 1, 1], "statistics of pictures are [3][1][1]")
                check(all(-1e-9 <= v[0][0] <= 1 for v in mine[statistic]), "in 0..1")
            continue
        rows = data[name].to_pylist()
        columns = list(zip(*[row if isinstance(row, list) else [row] for row in rows]))
        check(mine["count"] == [len(rows)], f"count of {name}")
        for i, column in enumerate(columns):
            mean = math.fsum(column) / len(column)
            deviation = math.sqrt(math.fsum((v - mean) ** 2 for v in column) / len(column))
            check(mine["min"][i] == min(column) and mine["max"][i] == max(column), f"{name} range")
            check(close(mine["mean"][i], mean), f"{name} mean")
            check(close(mine["std"][i], deviation), f"{name} deviation")
            check(mine["min"][i] - 1e-6 <= mine["q01"][i] <= mine["q50"][i] <= mine["q99"][i]
                  <= mine["max"][i] + 1e-6, f"{name} quantiles")
        weights = [entry[f"stats/{name}/count"][0] for entry in episodes]
        for quantile in ["q01", "q10", "q50", "q90", "q99"]:
            for i in range(len(columns)):
                mean = sum(w * entry[f"stats/{name}/{quantile}"][i]
                           for w, entry in zip(weights, episodes)) / sum(weights)
                check(close(mine[quantile][i], mean), f"{name} {quantile} is weighted by count")


def compare_schemas(root, reference):
    for file in ["data/chunk-000/file-000.parquet", "meta/tasks.parquet",
                 "meta/episodes/chunk-000/file-000.parquet"]:
        mine, theirs = (pq.read_schema(base / file) for base in (root, reference))
        for field in theirs:
            check(field.name in mine.names, f"{file}: has {field.name}")
            check(mine.field(field.name).type == field.type,
                  f"{file}: {field.name} is {field.type}, not {mine.field(field.name).type}")
        keys = set(theirs.metadata or {})
        check(keys == set(mine.metadata or {}), f"{file}: footer has {keys}")
        if b"pandas" in keys:
            check(json.loads(mine.metadata[b"pandas"]) == json.loads(theirs.metadata[b"pandas"]),
                  f"{file}: what pandas is told")
    mine, theirs = (json.loads((base / "meta/info.json").read_text())
                    for base in (root, reference))
    check(list(mine) == list(theirs), "info.json has the same keys in the same order")
    for key in ["codebase_version", "chunks_size", "data_files_size_in_mb",
                "video_files_size_in_mb", "data_path", "video_path"]:
        check(mine[key] == theirs[key], f"info.json: {key}")
    for name, feature in theirs["features"].items():
        check(list(mine["features"][name]) == list(feature), f"info.json: keys of {name}")
        check(mine["features"][name]["dtype"] == feature["dtype"], f"info.json: type of {name}")
        check(mine["features"][name]["names"] == feature["names"], f"info.json: names of {name}")
        if "info" in feature:
            check(list(mine["features"][name]["info"]) == list(feature["info"]), "video info")


def main():
    recorder = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch) / "set"
        subprocess.run([recorder, str(root), "3"], check=True)
        info = json.loads((root / "meta/info.json").read_text())
        data = check_tables(root, info)
        episodes = check_episodes(root, info, data)
        check_statistics(root, info, data, episodes)
        tasks = pq.read_table(root / "meta/tasks.parquet").to_pylist()
        check(len(tasks) == 1 and tasks[0]["task_index"] == 0, "one task")
        if len(sys.argv) > 2 and pathlib.Path(sys.argv[2], "meta/info.json").exists():
            compare_schemas(root, pathlib.Path(sys.argv[2]))
        else:
            print("no reference dataset: schemas were not compared with lerobot's")
        print(f"read {data.num_rows} rows of {len(episodes)} episodes")


main()
