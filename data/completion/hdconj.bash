# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of hdconj for bash: verbs, options, their words, scene files.
# The test docs.completion compares the verbs and the options with those of the program, python.study_faults those of
# hdconj study.

_hdconj()
{
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
    local common="--help --set --threads --json --quiet"
    local verbs="init design check solve contact load run wedm accuracy inspect export report study help version"
    local study="check run optimise status best picture"
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        case $current in
            -*) COMPREPLY=($(compgen -W "--help --version" -- "$current")) ;;
            *) COMPREPLY=($(compgen -W "$verbs" -- "$current")) ;;
        esac
        return
    fi

    case $previous in
        help) COMPREPLY=($(compgen -W "$verbs" -- "$current")); return ;;
        --surface) COMPREPLY=($(compgen -W "tilted ruled per-slice" -- "$current")); return ;;
        --kind) COMPREPLY=($(compgen -W "radial draft" -- "$current")); return ;;
        --part) COMPREPLY=($(compgen -W "circular-spline flexspline" -- "$current")); return ;;
        --output-member) COMPREPLY=($(compgen -W "cup circular-spline" -- "$current")); return ;;
        --dialect)
            COMPREPLY=($(compgen -W "dxf xyuv-guide xyuv-face csv relative-uv two-plane 3b iso-2d" -- "$current"))
            return ;;
        --like) COMPREPLY=($(compgen -W "size-14 size-17 size-20 size-25 size-32" -- "$current")); return ;;
        --family)
            COMPREPLY=($(compgen -W "double-circular-arc straight involute cycloid s-tooth arc-chain bezier b-spline" \
                -- "$current"))
            return ;;
        --register) COMPREPLY=($(compgen -W "datum turn least-squares minimum-zone" -- "$current")); return ;;
        --with) COMPREPLY=($(compgen -W "solve contact load run wedm design" -- "$current")); return ;;
        --for) COMPREPLY=($(compgen -W "solve contact load run" -- "$current")); return ;;
    esac

    local options
    case ${COMP_WORDS[1]} in
        init) options="--help --like --force --quiet" ;;
        design)
            options="--help --ratio --diameter --module --length-ratio --torque --family --material --land --clearance"
            options="$options --safety --fatigue --youngs-modulus --poissons-ratio --output --force --json --quiet" ;;
        check) options="$common --strict --plan --for" ;;
        solve) options="$common --strict --output --dxf --picture --spline-tooth --cam --inner-surface --completed --verbose" ;;
        contact)
            options="$common --strict --tilt --surface --kind --best --revolution --no-errors --output"
            options="$options --picture --xdmf --stl --vtk --ring" ;;
        load)
            options="$common --strict --torque --points --tilt --surface --kind --no-curve --no-errors --output"
            options="$options --picture --vtu --measured --torque-constant --counts-per-turn --ratio --efficiency"
            options="$options --output-member" ;;
        run) options="$common --strict --torque --positions --no-errors --output --picture" ;;
        wedm) options="$common --strict --part --tilt --output --from --dialect --decimals --picture" ;;
        accuracy)
            options="$common --study --output --sample --repeats --quick --from --budget --error --page" ;;
        inspect) options="$common --part --plane --probe --register --deviations --pitch --output --picture --as-tooth" ;;
        export) options="$common --calculix --contact --vtu --steps" ;;
        report) options="--help --set --threads --json --quiet --output --with --tilt --revolution --no-curve" ;;
        study)
            if [ "$COMP_CWORD" -eq 2 ]; then
                case $current in
                    -*) COMPREPLY=($(compgen -W "--help" -- "$current")) ;;
                    *) COMPREPLY=($(compgen -W "$study" -- "$current")) ;;
                esac
                return
            fi
            case ${COMP_WORDS[2]} in
                run | optimise) options="--help --jobs --scheduler --shard-seconds --quiet" ;;
                best) options="--help --csv --scene" ;;
                *) options="--help" ;;
            esac ;;
    esac
    case $current in
        -*) COMPREPLY=($(compgen -W "$options" -- "$current")) ;;
        *) COMPREPLY=($(compgen -f -- "$current")) ;;
    esac
}

complete -o filenames -o bashdefault -F _hdconj hdconj
