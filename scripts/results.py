#!/usr/bin/python3
"""scripts/results.py FOLDER: how to open the trials of a study in pandas; success by point, method."""
import sys

import h5py
import pandas

with h5py.File(f"{sys.argv[1]}/trials.h5") as file:
    trials = pandas.DataFrame({name: column.asstr()[:] if column.dtype == object else column[:]
                               for name, column in file["trials"].items()})
rate = "success" if "success" in trials else "mapped"
trials[rate] = trials[rate].fillna(0)  # a failed trial is no success
axes = [name for name in trials if "." in name]  # the keys that the study varies
print(trials.groupby(axes + ["method"])[rate].agg(["mean", "count"]))
