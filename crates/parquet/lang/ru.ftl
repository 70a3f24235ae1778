# Файлы Parquet.
parquet-failed = Parquet: { $problem }
