# Files of Parquet.
parquet-failed = Parquet: { $problem }
