"""Tables in memory: Arrow tables of CSV and Parquet files, and the cells of any table by column."""
