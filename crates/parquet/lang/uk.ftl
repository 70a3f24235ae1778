# Файли Parquet.
parquet-failed = Parquet: { $problem }
