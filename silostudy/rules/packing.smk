# Packing studies: ensembles of discs at rest and in discharge, and single runs in detail.


rule packing:
    input:
        study_files,
    output:
        RESULTS + "/{study}/packing.nc",
    params:
        code=stamp(*STAGES["packing"]),
    threads: 2
    log:
        RESULTS + "/{study}/logs/packing.log",
    benchmark:
        RESULTS + "/{study}/cost/packing.tsv"
    shell:
        "python -m silostudy packing {input[0]} {output} > {log} 2>&1"


rule motion:
    input:
        study_files,
    output:
        RESULTS + "/{study}/motion.nc",
    params:
        code=stamp(*STAGES["motion"]),
    log:
        RESULTS + "/{study}/logs/motion.log",
    benchmark:
        RESULTS + "/{study}/cost/motion.tsv"
    shell:
        "python -m silostudy motion {input[0]} {output} > {log} 2>&1"
